#include "flip_outputs.hpp"

#include <tightflip/kernel/file_io.hpp>

#include <filesystem>

namespace tightflip::tools {

namespace {

bool same_file(const std::string& a, const std::string& b) {
    const auto place = [](const std::string& name) {
        std::error_code ignored;  // a path that cannot be followed is compared as it is
        return std::filesystem::weakly_canonical(std::filesystem::absolute(name, ignored), ignored);
    };
    return place(a) == place(b);
}

}  // namespace

void require_distinct(const std::vector<NamedFile>& files) {
    for (auto later = files.begin(); later != files.end(); ++later) {
        for (auto earlier = files.begin(); earlier != later; ++earlier) {
            if (later->file.empty() || earlier->file.empty()) continue;
            if (!same_file(later->file, earlier->file)) continue;
            throw CLI::ValidationError(later->option,
                                       "must be another file than " + earlier->option);
        }
    }
}

void FlipOutputs::write(const kernel::FlipLogView& flips,
                        const std::function<void(const std::string& file)>& write_surface) const {
    const auto write_end = [&] {
        if (!surface.empty()) write_surface(surface);
    };
    if (log.empty()) return write_end();
    kernel::write_file(log, [&](std::ostream& out) {
        binary ? write_binary(out, flips) : write_text(out, flips);
        if (out.flush()) write_end();  // before the log takes its name
    });
}

}  // namespace tightflip::tools
