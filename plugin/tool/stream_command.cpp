// SPDX-License-Identifier: Apache-2.0
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>
#include <thread>

#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "core/base/parallel.h"
#include "ddt/devices.h"
#include "plugin/host/request.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/threads.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/stream/hand_over.h"
#include "plugin/tool/stream/stream_frame.h"

namespace ddt::tool {

namespace {

/// What the stream ended with; the first failure counts.
class Verdict {
public:
    void fail(int64_t frame, const std::string& why, ExitCode code) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (m_failure.code == exit_done)
            m_failure = {"ddt: frame " + std::to_string(frame) + ": " + why, code};
    }
    const Failure& failure() const { return m_failure; }

private:
    std::mutex m_mutex;
    Failure m_failure{"", exit_done};
};

class StreamCommand final : public Command {
public:
    StreamCommand() {
        name = "stream";
        summary = "Enlarge the pictures of a stream";
        paragraphs = {
            "Reads PAM, PPM, PGM or PFM pictures from the standard input, one after the other, and "
            "writes each enlarged to the standard output as soon as it is done, for pipes such as "
            "ffmpeg -i in.mp4 -f image2pipe -c:v pam - | ddt stream --scale 2 | ffmpeg -framerate "
            "24 -f image2pipe -c:v pam -i - out.mp4, with the video's own rate in place of 24. One "
            "picture is read and one written while a third is worked on.",
            "Numbers of PAM, PPM and PGM are taken to be sRGB, those of PFM linear light; the "
            "filter's option light= says otherwise. Whatever is told of it with the others, here "
            "it may "
            "be auto, " +
                OIIO::Strutil::join(host::meaning_names(), ", ") +
                "; $OCIO is not looked at. PAM's alpha is not associated. Pictures of "
                "other largest values than 255 and 65535 become such of 16 bits."};
        flags = {
            number_flag("--scale", "S", "by how much both sides grow (default: 2)", 1, 1024,
                        m_scale),
            filter_flag("the filter's name and options (default: ddt): ddt-sharp,light=encoded",
                        m_options, m_filter_error),
            threads_flag(m_threads),
        };
    }

    ExitCode run(const std::vector<std::string>&) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        host::Enlargement work;
        std::string error;
        if (!host::set_filter(m_options, "sRGB", work, error))
            return fail(error, exit_usage);
        if (!check_device(work.device, error))
            return fail(error, exit_failed);
        allow_threads(m_threads);
        Verdict verdict;
        HandOver<Frame> read, made;
        std::thread writer([&] { write_all(made, read, verdict); });
        std::thread reader;
        try {
            reader = std::thread([&] { read_all(read, verdict); });
        } catch (const std::system_error&) {
            made.close();
            writer.join();
            throw;
        }
        enlarge_all(read, made, verdict);
        made.close();
        read.close();
        writer.join();
        finish(reader, verdict);
        return verdict.failure().code == exit_done ? exit_done : fail(verdict.failure());
    }

private:
    void read_all(HandOver<Frame>& read, Verdict& verdict) {
        for (int64_t n = 1;; ++n) {
            Frame frame;
            Failure failure;
            ReadResult result = ReadResult::failed;
            try {
                result = read_frame(stdin, frame, failure);
                if (result == ReadResult::failed)
                    verdict.fail(n, failure.why, failure.code);
            } catch (const std::bad_alloc&) {
                verdict.fail(n, out_of_memory_text, exit_resources);
            }
            if (result != ReadResult::frame || !read.put(std::move(frame)))
                break;
        }
        m_reading = false;
        read.close();
    }

    void enlarge_all(HandOver<Frame>& read, HandOver<Frame>& made, Verdict& verdict) {
        int64_t n = 0;
        while (auto frame = read.take()) {
            ++n;
            Frame large;
            std::string error;
            const Outcome outcome = enlarge(*frame, large, error);
            if (outcome != Outcome::done)
                return verdict.fail(n, without_prefix(error),
                                    outcome == Outcome::bad_job ? code_of_message(error)
                                                                : exit_resources);
            if (!made.put(std::move(large)))
                return;
        }
    }

    Outcome enlarge(Frame& frame, Frame& large, std::string& error) const {
        host::Enlargement work;
        if (!host::set_filter(m_options, frame.is_float() ? "linear" : "sRGB", work, error))
            return Outcome::bad_job;
        work.threads = m_threads;
        work.layout = host::Layout::usual(frame.channels, false);
        work.from = frame.buffer();
        work.place = host::onto(work.from.box, host::scaled(work.from.box, m_scale, m_scale));
        try {
            large = frame.of_size(work.place.full.width(), work.place.full.height());
            if (!large.allocate(error)) {
                error = "ddt: " + error;
                return Outcome::bad_job;
            }
        } catch (const std::bad_alloc&) {
            error = with_prefix(out_of_memory_text);
            return Outcome::out_of_memory;
        }
        work.to = large.buffer();
        return host::enlarge(work, error);
    }

    static void write_all(HandOver<Frame>& made, HandOver<Frame>& read, Verdict& verdict) {
        int64_t n = 0;
        while (auto frame = made.take()) {
            std::string error;
            if (write_frame(stdout, *frame, error) && ++n)
                continue;
            verdict.fail(n + 1, error, code_of_errno(errno));
            made.close();
            read.close();
            return;
        }
    }

    /// The reader may wait for a picture that never comes while nobody wants it any more: then the
    /// process ends without it.
    void finish(std::thread& reader, const Verdict& verdict) {
        if (verdict.failure().code != exit_done && m_reading) {
            fail(verdict.failure());
            std::_Exit(verdict.failure().code);
        }
        reader.join();
    }

    double m_scale = 2;
    Options m_options;
    std::string m_filter_error;
    int m_threads = 0;
    std::atomic<bool> m_reading{true};
};

} // namespace

std::unique_ptr<Command> make_stream_command() {
    return std::make_unique<StreamCommand>();
}

} // namespace ddt::tool
