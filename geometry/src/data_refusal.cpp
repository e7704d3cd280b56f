#include <tightflip/geometry/data_refusal.hpp>

namespace tightflip::geometry {
namespace {

/// The words of a fault; {0} and {1} stand for the witness.
const char* pattern(DataFault fault) {
    switch (fault) {
        case DataFault::none:
            break;
        case DataFault::too_few_points:
            return "there are too few points";
        case DataFault::not_finite:
            return "point {0} has a coordinate that is not finite";
        case DataFault::coincident_points:
            return "points {0} and {1} coincide";
        case DataFault::collinear_points:
            return "all points lie on one line";
        case DataFault::coplanar_points:
            return "all points lie in one plane";
        case DataFault::interior_point:
            return "the data are not convex: point {0} lies inside the hull";
        case DataFault::shared_direction:
            return "points {0} and {1} lie in the same direction from the centre";
        case DataFault::centre_outside:
            return "the centre does not lie inside the convex hull of the points";
        case DataFault::too_few_sections:
            return "there are too few sections: two are needed";
        case DataFault::contour_too_short:
            return "section {0} has fewer than three points";
        case DataFault::contour_not_horizontal:
            return "section {0} is not horizontal: point {1} is at another height";
        case DataFault::contours_not_ascending:
            return "section {0} is not higher than the one before it";
        case DataFault::contour_not_simple:
            return "a contour meets itself: in the sides that start at points {0} and {1}";
    }
    return "";
}

}  // namespace

std::string message(const DataRefusal& refusal) {
    std::string text = pattern(refusal.fault);
    for (const std::size_t i : {0U, 1U}) {
        const std::string place = i == 0 ? "{0}" : "{1}";
        const std::size_t found = text.find(place);
        if (found != std::string::npos) {
            text.replace(found, place.size(), std::to_string(refusal.witness.at(i)));
        }
    }
    return text;
}

}  // namespace tightflip::geometry
