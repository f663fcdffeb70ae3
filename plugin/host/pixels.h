// SPDX-License-Identifier: Apache-2.0
// A host's buffers as the core's source and sink.
#pragma once

#include "plugin/host/enlargement.h"

namespace ddt::host {

/// Whether colour is multiplied by alpha before the work and divided by it afterwards.
bool must_associate(const Layout& layout);

/// What memory holds, to what the core works on, and back: associated linear light, or as it is.
void to_work(const Enlargement& work, float* values, size_t count);
void from_work(const Enlargement& work, float* values, size_t count);

class HostSource final : public Source {
public:
    explicit HostSource(const Enlargement& work);
    bool read(const Rect& r, float* values, float* guide) override;
    /// Of 8 bits and of halfs, all channels of which convert alike.
    std::vector<float> codes() override;
    bool read_codes(const Rect& r, void* codes, float* guide) override;

private:
    void read_row(int y, const Rect& r, float* values) const;

    const Enlargement& m_work;
    GuideRecipe m_guide;
};

class HostSink final : public Sink {
public:
    explicit HostSink(const Enlargement& work) : m_work(work) {}
    bool write(const Rect& r, float* values) override;
    float* place(const Rect& r, size_t& row) override;
    /// Into halfs, of numbers that stay as they are.
    bool takes_halfs() const override;
    /// Into 8 bits, of colour alone, alike in all channels.
    const CodeTable* takes_codes() const override;
    bool write_packed(const Rect& r, const void* numbers) override;

private:
    bool as_they_are() const;
    bool write_codes(const Rect& r, const float* values) const;

    const Enlargement& m_work;
};

} // namespace ddt::host
