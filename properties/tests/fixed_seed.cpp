// RapidCheck draws a new seed every run unless RC_PARAMS names one. Here runs without RC_PARAMS
// always use the same seed, so that a build is judged the same everywhere; RapidCheck prints what
// it uses, and `RC_PARAMS="seed=7 max_success=1000"` or a failure's "reproduce=..." overrides it.

#include <cstdlib>

#include <gtest/gtest.h>

namespace {

class FixedSeed : public ::testing::Environment {
public:
    void SetUp() override { setenv("RC_PARAMS", "seed=20010401", /*overwrite=*/0); }
};

[[maybe_unused]] const auto* const registered = ::testing::AddGlobalTestEnvironment(new FixedSeed);

}  // namespace
