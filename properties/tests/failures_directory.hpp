/// \file
/// Where failing cases go, for the length of a test.
#pragma once

#include <tightflip/properties/failing_case.hpp>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace tightflip::properties {

/// An empty directory of that name, removed in the end.
class FailuresDirectory {
public:
    explicit FailuresDirectory(const std::string& name)
        : path_(std::filesystem::path(::testing::TempDir()) / ("tightflip_" + name)) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
        name_instead(path_);
    }
    ~FailuresDirectory() {
        unsetenv(failures_directory_variable);
        std::filesystem::remove_all(path_);
    }
    FailuresDirectory(const FailuresDirectory&) = delete;
    FailuresDirectory& operator=(const FailuresDirectory&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// From now on failing cases go to this place, say one in the directory that cannot be made.
    static void name_instead(const std::filesystem::path& place) {
        setenv(failures_directory_variable, place.c_str(), 1);
    }

private:
    std::filesystem::path path_;
};

}  // namespace tightflip::properties
