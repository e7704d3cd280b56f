/// \file
/// Any file the command takes as a surface.
#pragma once

#include "command.hpp"
#include <tightflip/geometry/surface_file.hpp>

#include <string>

namespace tightflip::tools {

/// How to take a file; added to every verb that reads surfaces.
struct InputOptions {
    bool triangulate = false;
    bool reorient = false;
    std::string weld;  ///< a distance as it was given; empty where it was not
    geometry::RepairOptions repair{};
    bool repair_all = false;

    void add_triangulate(CLI::App& verb);
    void add_reorient(CLI::App& verb);
    /// The options that mend a mesh file: --weld, --drop-faces, --drop-unused, --fill-holes and,
    /// for all of them, --repair.
    void add_repair(CLI::App& verb);
};

/// A file that could be read, see geometry::SurfaceFile; whether it is a valid surface is for the
/// audit to say.
class SurfaceInput : public geometry::SurfaceFile {
public:
    /// Throws kernel::FileError where the file cannot be understood.
    SurfaceInput(const std::string& path, const InputOptions& options);

    /// What was mended, a line each; nothing where nothing was asked for.
    void say_repairs(const Output& output) const;
    /// Adds the key "repairs" of docs/formats.md where repairs were asked for.
    void add_repairs(Json& json) const;
};

}  // namespace tightflip::tools
