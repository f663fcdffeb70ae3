// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/id_names.h"

#include <gtest/gtest.h>

#include "tests/plugin/image/named.h"

namespace {

TEST(IdNames, AreThoseWhoseLastWordIsId) {
    for (const char* name :
         {"id", "ID", "Id", "objectId", "objectID", "materialid", "prim_id", "prim-id", "layer.ID",
          "node.id", "OBJECTID", "instance2id", "uid", "layer.primid", "gridID"})
        EXPECT_TRUE(ddt::is_id_name(name)) << name;
}

// The edges of mattes would be steps.
TEST(IdNames, AreNoWordsThatEndSo) {
    for (const char* name :
         {"",        "d",           "i",        "R",       "grid",           "GRID",     "uvGrid",
          "fluid",   "layer.solid", "Void",     "idle",    "id.R",           "centroid", "eyelid",
          "deltoid", "toroid",      "arachnid", "hominid", "matte.arachnid", "timid",    "horrid",
          "stupid",  "lurid",       "squid",    "languid"})
        EXPECT_FALSE(ddt::is_id_name(name)) << name;
}

TEST(IdNames, OfCryptomattesOfAnyProgram) {
    for (const char* name :
         {"CryptoObject00.R", "View.CryptoObject00.r", "uCryptoAsset00.R", "VRayCryptomatte00.R",
          "rs_Cryptomatte00.R", "Redshift_Cryptomatte00.R", "RenderLayer_CryptoObject00.R",
          "crypto_v2_object00.R", "cryptoObject2_00.R", "crypto-object00.R",
          "CryptoObject00.left.R", "crypto_asset01"})
        EXPECT_TRUE(ddt::is_cryptomatte(name, {})) << name;
    for (const char* name : {"CryptoObject.R", "crypto.00", "matte00.R", "Crypto0.R", "R", ""})
        EXPECT_FALSE(ddt::is_cryptomatte(name, {})) << name;
}

TEST(IdNames, OfCryptomattesByMetadata) {
    OIIO::ImageSpec spec = ddt::test::named({"R"});
    spec.attribute("cryptomatte/1a2b3c/name", "matte");
    spec.attribute("cryptomatte/1a2b3c/hash", "other");
    const std::vector<std::string> known = ddt::cryptomattes(spec);
    EXPECT_EQ(known, std::vector<std::string>{"matte"});
    for (const char* name : {"matte00.R", "matte01", "Matte02.left.A"})
        EXPECT_TRUE(ddt::is_cryptomatte(name, known)) << name;
    for (const char* name : {"matte.R", "matte000.R", "matte0.R", "other00.R", "a.matte00.R"})
        EXPECT_FALSE(ddt::is_cryptomatte(name, known)) << name;
}

} // namespace
