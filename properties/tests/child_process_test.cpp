#include <tightflip/properties/child_process.hpp>

#include <csignal>
#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

namespace tightflip::properties {
namespace {

/// Writes something, and then does what is to be seen.
ChildResult after_a_word(const std::function<void()>& rest) {
    return run_in_child(
        [&](const ChildOutput& write) {
            write("begun");
            rest();
        },
        1);
}

TEST(ChildProcess, GivesBackAllThatWasWritten) {
    const ChildResult child = after_a_word([] {});
    EXPECT_EQ(child.output, "begun");
    EXPECT_EQ(child.failure, "");
    EXPECT_FALSE(child.timed_out);

    const std::string much(1000000, 'x');
    EXPECT_EQ(run_in_child([&](const ChildOutput& write) { write(much); }, 5).output, much);
}

TEST(ChildProcess, IsEndedWhenItsTimeIsUp) {
    const ChildResult child = after_a_word([] {
        for (;;) {
            volatile int forever = 0;
            static_cast<void>(forever);
        }
    });
    EXPECT_EQ(child.output, "begun");
    EXPECT_EQ(child.failure, "did not answer within 1 s");
    EXPECT_TRUE(child.timed_out);
}

TEST(ChildProcess, FailsUnlessTheWorkIsDone) {
    const ChildResult crashed = after_a_word([] { std::raise(SIGSEGV); });
    EXPECT_EQ(crashed.output, "begun");
    EXPECT_EQ(crashed.failure.rfind("was ended by signal 11", 0), 0U) << crashed.failure;

    for (const auto leave : {std::exit, std::_Exit}) {
        const ChildResult gone = after_a_word([&] { leave(0); });
        EXPECT_EQ(gone.output, "begun");
        EXPECT_EQ(gone.failure, "ended its process with exit code 0");
        EXPECT_FALSE(gone.timed_out);
    }
}

TEST(ChildProcess, PassesOnWhatTheWorkThrows) {
    const ChildResult child = after_a_word([] { throw std::runtime_error("out of sorts"); });
    EXPECT_EQ(child.output, "begun");
    EXPECT_EQ(child.failure, "threw: out of sorts");
    EXPECT_EQ(after_a_word([] { throw 7; }).failure, "threw: something that is no std::exception");
}

TEST(RunHere, AnswersAsAChildDoes) {
    const ChildResult here = run_here([](const ChildOutput& write) {
        write("begun");
        write(" and");
        throw std::runtime_error("out of sorts");
    });
    EXPECT_EQ(here.output, "begun and");
    EXPECT_EQ(here.failure, "threw: out of sorts");
    EXPECT_EQ(run_here([](const ChildOutput&) {}).failure, "");
}

}  // namespace
}  // namespace tightflip::properties
