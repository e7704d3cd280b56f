#include "formats.hpp"
#include "mesh_text.hpp"
#include <tightflip/geometry/mesh_file.hpp>
#include <tightflip/kernel/file_io.hpp>

#include <algorithm>
#include <array>

namespace tightflip::geometry {
namespace {

struct Format {
    MeshFormat format;
    std::string_view extension;
    bool (*looks_alike)(std::string_view bytes);
    TriangleSoup (*read)(const MeshInput& input);
};

/// In the order in which content is tried. The size of a binary STL file is the surest sign, and
/// its first bytes, which may say anything, would mislead the others.
constexpr std::array<Format, 4> formats{{{MeshFormat::stl, ".stl", looks_like_stl, read_stl},
                                         {MeshFormat::ply, ".ply", looks_like_ply, read_ply},
                                         {MeshFormat::off, ".off", looks_like_off, read_off},
                                         {MeshFormat::obj, ".obj", looks_like_obj, read_obj}}};

const Format& entry(MeshFormat format) {
    return *std::ranges::find(formats, format, &Format::format);
}

}  // namespace

std::string_view name(MeshFormat format) {
    return entry(format).extension.substr(1);
}

std::optional<MeshFormat> detect_mesh_format(std::string_view bytes,
                                             const std::filesystem::path& source) {
    const auto* found = std::ranges::find_if(
        formats, [&](const Format& format) { return format.looks_alike(bytes); });
    if (found == formats.end()) {
        found =
            std::ranges::find(formats, lowered(source.extension().string()), &Format::extension);
    }
    if (found == formats.end()) return std::nullopt;
    return found->format;
}

TriangleSoup read_mesh(std::string_view bytes, const std::string& source,
                       const MeshFileOptions& options) {
    if (bytes.empty()) throw FileError(source, "the file is empty");
    const auto format = options.format ? options.format : detect_mesh_format(bytes, source);
    if (!format) {
        throw FileError(source,
                        "neither the content nor the name's extension is that of an OBJ, OFF, PLY "
                        "or STL file; rename the file or name the format");
    }
    return entry(*format).read({bytes, source, options});
}

TriangleSoup read_mesh_file(const std::filesystem::path& path, const MeshFileOptions& options) {
    return read_mesh(kernel::read_file(path), path.string(), options);
}

}  // namespace tightflip::geometry
