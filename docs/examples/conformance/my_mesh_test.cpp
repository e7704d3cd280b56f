// The conformance suite on the adaptor.
#include "my_kernel.hpp"
#include <tightflip/properties/conformance_suite.hpp>

namespace tightflip::properties {

INSTANTIATE_TYPED_TEST_SUITE_P(MyMesh, MeshKernelSuite, MyKernel);

}  // namespace tightflip::properties
