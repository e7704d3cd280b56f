#include <tightflip/kernel/halfedge_audit.hpp>

namespace tightflip::kernel {

AuditReport audit(HalfedgeTable table, Index vertex_count, const AuditOptions& options) {
    return climb_audit_ladder(table, vertex_count, options);
}

}  // namespace tightflip::kernel
