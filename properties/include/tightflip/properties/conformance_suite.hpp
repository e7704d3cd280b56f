/// \file
/// The conformance suite as GoogleTest cases. Only includers of this header need GoogleTest.
///
/// \code
///     INSTANTIATE_TYPED_TEST_SUITE_P(MyMesh, MeshKernelSuite, MyKernel);
/// \endcode
///
/// Every case is a property. What is found is printed with its script; where the environment
/// variable TIGHTFLIP_FAILURES names a directory, logs are left there.
#pragma once

#include <tightflip/properties/conformance.hpp>
#include <tightflip/properties/flip_case.hpp>

#include <cstdlib>
#include <sstream>

#include <gtest/gtest.h>

namespace tightflip::properties {

/// Success, or the findings against a property with their scripts in words.
[[nodiscard]] inline ::testing::AssertionResult holds(const KernelReport& report,
                                                      KernelProperty property) {
    if (report.holds(property)) return ::testing::AssertionSuccess();
    std::ostringstream words;
    words << report.kernel << " does not keep: " << describe(property) << '\n';
    const char* const directory = std::getenv("TIGHTFLIP_FAILURES");
    for (const KernelFinding& finding : report.findings) {
        if (property_of(finding.code) != property) continue;
        words << describe(finding) << '\n';
        if (finding.step > 0) write_in_words(words, *finding.log);
        if (directory != nullptr) {
            words << "written to " << write_log(directory, report.kernel, finding) << '\n';
        }
    }
    return ::testing::AssertionFailure() << words.str();
}

template <class K>
class MeshKernelSuite : public ::testing::Test {
protected:
    static void expect(KernelProperty property) {
        static const KernelReport report = test_kernel(kernel_description<K>());
        if (!report.was_asked(property)) GTEST_SKIP() << "not promised";
        EXPECT_TRUE(holds(report, property));
    }
};

TYPED_TEST_SUITE_P(MeshKernelSuite);

TYPED_TEST_P(MeshKernelSuite, HoldsItsStart) {
    this->expect(KernelProperty::reading);
}
TYPED_TEST_P(MeshKernelSuite, KeepsTopology) {
    this->expect(KernelProperty::topology);
}
TYPED_TEST_P(MeshKernelSuite, ChangesNothingElsewhere) {
    this->expect(KernelProperty::locality);
}
TYPED_TEST_P(MeshKernelSuite, FlipsDiagonals) {
    this->expect(KernelProperty::definition);
}
TYPED_TEST_P(MeshKernelSuite, FlipsBack) {
    this->expect(KernelProperty::inverse);
}
TYPED_TEST_P(MeshKernelSuite, KeepsHandles) {
    this->expect(KernelProperty::handles);
}
TYPED_TEST_P(MeshKernelSuite, SaysTruthfullyWhatMayBeFlipped) {
    this->expect(KernelProperty::legality);
}
TYPED_TEST_P(MeshKernelSuite, ValidatesTruthfully) {
    this->expect(KernelProperty::validator);
}
TYPED_TEST_P(MeshKernelSuite, AgreesStepByStep) {
    this->expect(KernelProperty::agreement);
}
TYPED_TEST_P(MeshKernelSuite, Survives) {
    this->expect(KernelProperty::survival);
}

REGISTER_TYPED_TEST_SUITE_P(MeshKernelSuite, HoldsItsStart, KeepsTopology, ChangesNothingElsewhere,
                            FlipsDiagonals, FlipsBack, KeepsHandles, SaysTruthfullyWhatMayBeFlipped,
                            ValidatesTruthfully, AgreesStepByStep, Survives);

}  // namespace tightflip::properties
