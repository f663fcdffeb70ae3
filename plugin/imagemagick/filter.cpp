// SPDX-License-Identifier: Apache-2.0
// The filter module `ddt` of ImageMagick 6 and 7:
//
//     convert in.png -process "ddt 4 ddt-sharp,cost=scf" out.png
//     magick in.png -process "ddt 4 ddt-sharp,cost=scf" out.png
//
// The first argument is a factor from 1 on, the second, which may be left out, a filter with its
// options. sRGB and Gray images go through linear light, RGB and LinearGray ones are it.
#include <memory>
#include <string>
#include <vector>

#include "core/base/guarded.h"
#include "core/base/one_line.h"
#include "core/base/parse_number.h"
#include "plugin/host/request.h"
#include "plugin/imagemagick/api.h"
#include "plugin/imagemagick/numbers.h"

namespace {

using namespace ddt::host;
using namespace ddt::magick;
using ddt::Rect;

/// What the user asked for.
struct Request {
    double scale = 0;
    std::string filter = "ddt";
};

void complain(ExceptionInfo* exception, ExceptionType type, const std::string& error) {
    (void)ThrowMagickException(exception, GetMagickModule(), type, error.c_str(), "`%s'", "ddt");
}

bool parse(int argc, const char** argv, Request& request, std::string& error) {
    if (argc < 1 || argc > 2 || !ddt::parse_number(argv[0], 1.0, 1e4, request.scale)) {
        error =
            "ddt: allowed are a scale from 1 to 10000 and a filter: -process \"ddt 4 ddt-sharp\"";
        return false;
    }
    if (argc > 1)
        request.filter = argv[1];
    return true;
}

bool is_grey(const Image& image) {
    return image.colorspace == GRAYColorspace || image.colorspace == LinearGRAYColorspace;
}

/// The light of an image's numbers, or null where they are neither grey nor red, green and blue.
const char* light_of(const Image& image) {
    switch (image.colorspace) {
    case sRGBColorspace:
    case GRAYColorspace:
    case UndefinedColorspace:
        return "sRGB";
    case RGBColorspace:
    case LinearGRAYColorspace:
        return "linear";
    default:
        return nullptr;
    }
}

/// Tells ImageMagick's monitor, which may say no.
struct Progress {
    const Image* image;
    bool operator()(float share) const {
        return SetImageProgress(image, "Enlarge/ddt", MagickOffsetType(share * 1000.0f), 1001) !=
               MagickFalse;
    }
};

/// The enlarged image, or null with an exception.
Image* enlarged(Image& image, const Request& request, ExceptionInfo* exception) {
    Enlargement work;
    std::string error;
    const char* light = light_of(image);
    if (!light) {
        const char* space = CommandOptionToMnemonic(MagickColorspaceOptions, image.colorspace);
        complain(exception, OptionError,
                 std::string("ddt: the colorspace ") + space +
                     " is not allowed; allowed are sRGB, RGB, Gray, LinearGray (-colorspace)");
        return nullptr;
    }
    if (!set_filter(request.filter, light, work, error)) {
        complain(exception, OptionError, error);
        return nullptr;
    }
    work.layout = Layout::usual((is_grey(image) ? 1 : 3) + (has_alpha(image) ? 1 : 0), false);
    const Rect window{0, 0, int(image.columns), int(image.rows)},
        full = scaled(window, request.scale, request.scale);
    work.place = onto(window, full);

    using Owned = std::unique_ptr<Image, Image* (*)(Image*)>;
    Owned result(
        CloneImage(&image, size_t(full.width()), size_t(full.height()), MagickTrue, exception),
        DestroyImage);
    if (!result || !keep_pixels(*result, exception))
        return nullptr;
    const char* const maps[] = {"R", "RA", "RGB", "RGBA"};
    const char* const back[] = {"I", "IA", "RGB", "RGBA"};
    const int map = work.layout.channels - 1;
    Numbers from;
    if (!from.take(image, window, maps[map], work.layout.channels, exception))
        return nullptr;
    std::vector<Number> to;
    work.from = from.buffer();
    work.to = buffer_of(to, full, work.layout.channels);
    work.threads = threads_within(GetMagickResourceLimit(ThreadResource));
    work.progress = Progress{&image};
    const ddt::Outcome outcome = enlarge(work, error);
    if (outcome != ddt::Outcome::done) {
        complain(exception,
                 outcome == ddt::Outcome::out_of_memory ? ResourceLimitError : OptionError, error);
        return nullptr;
    }
    if (!import_pixels(*result, back[map], number_type, to.data(), exception))
        return nullptr;
    // Which grey that comes in makes those of Gray.
    result->colorspace = image.colorspace;
    result->gamma = image.gamma;
    result->chromaticity = image.chromaticity;
    result->rendering_intent = image.rendering_intent;
    return result.release();
}

struct ListDestroyer {
    void operator()(Image* list) const { (void)DestroyImageList(list); }
};

/// In case of an exception the images stay as they are, as with filters of ImageMagick's own: none
/// at all would be an assertion of its own. `convert` tells the exception and ends with 1.
void enlarge_list(Image** images, const Request& request, ExceptionInfo* exception) {
    std::unique_ptr<Image, ListDestroyer> done;
    for (Image* i = GetFirstImageInList(*images); i; i = GetNextImageInList(i)) {
        Image* large = enlarged(*i, request, exception);
        if (!large)
            return;
        Image* list = done.release();
        AppendImageToList(&list, large);
        done.reset(GetFirstImageInList(list));
    }
    (void)DestroyImageList(*images);
    *images = done.release();
}

} // namespace

extern "C" ModuleExport size_t ddtImage(Image** images, const int argc, const char** argv,
                                        ExceptionInfo* exception);

size_t ddtImage(Image** images, const int argc, const char** argv, ExceptionInfo* exception) {
    std::string error;
    bool understood = true;
    const ddt::Caught caught = ddt::guarded_call(&error, [&] {
        Request request;
        understood = parse(argc, argv, request, error);
        if (understood)
            enlarge_list(images, request, exception);
    });
    if (caught != ddt::Caught::nothing)
        complain(exception, ResourceLimitError,
                 error.empty() ? ddt::with_prefix(ddt::out_of_memory_text) : error);
    else if (!understood)
        complain(exception, OptionError, error);
    return MagickImageFilterSignature;
}
