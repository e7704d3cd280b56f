#include <tightflip/kernel/audit.hpp>
#include <tightflip/kernel/audit_ladder.hpp>

namespace tightflip::kernel {

AuditReport audit(GluingView gluing, const AuditOptions& options) {
    return climb_audit_ladder(gluing, options);
}

}  // namespace tightflip::kernel
