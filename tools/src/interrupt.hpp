/// \file
/// Ctrl-C and its like end long runs in good order.
#pragma once

namespace tightflip::tools {

/// From now on SIGINT and SIGTERM no longer end the process but are noted.
void note_interrupts();
[[nodiscard]] bool was_interrupted();

}  // namespace tightflip::tools
