// SPDX-License-Identifier: LGPL-2.1-or-later
#include "status.h"

namespace laminate_offset
{
namespace
{

struct StatusText
{
    std::string_view name;
    std::string_view sentence;
    std::string_view remedy;
};

StatusText text(Status status)
{
    switch (status)
    {
    case Status::Ok: return {"ok", "The offset was made.", "Nothing to do."};
    case Status::NullShape: return {"null-shape", "No shape was given.", "Select a face of a recomputed object."};
    case Status::NotAFace:
        return {"not-a-face", "The shape is not a single face.", "Select one face, or pass the faces one by one."};
    case Status::InvalidFace:
        return {"invalid-face", "The face cannot be read as a trimmed surface.",
                "Check the shape's geometry and repair the face, then try again."};
    case Status::OpenLoop:
        return {"open-loop", "A trimming loop of the face does not close.",
                "Close the loop at the reported place, or heal the face."};
    case Status::ZeroArea:
        return {"zero-area", "The face encloses no area.", "Remove the degenerate face or repair its loops."};
    case Status::NotFinite:
        return {"not-finite", "The face holds coordinates that are not finite numbers.",
                "Import the model again or rebuild the face."};
    case Status::UnboundedFace:
        return {"unbounded-face", "The face is not bounded by trimming loops.",
                "Trim the surface to a finite face first."};
    case Status::InvalidDistance:
        return {"invalid-distance", "The distance is not a finite number.", "Give the distance in millimetres."};
    case Status::InvalidTolerance:
        return {"invalid-tolerance", "The tolerance is not a positive finite number.",
                "Give a tolerance above zero, in millimetres."};
    case Status::InvalidOption:
        return {"invalid-option", "An option is out of its range.", "See the message for the option and its range."};
    case Status::NotSupported:
        return {"not-supported", "This version does not offset this kind of face.",
                "See the message for the kind and what would work."};
    case Status::KinkedSurface:
        return {"kinked-surface", "The surface has a crease, so its offset is torn there.",
                "Split the face along the crease at the reported place and offset the parts."};
    case Status::SingularNormal:
        return {"singular-normal", "The surface has no normal at a place inside the trimming loops.",
                "Trim the face clear of the reported place."};
    case Status::CurvatureLimit:
        return {"curvature-limit", "The distance passes the surface's radius of curvature, so the offset would fold.",
                "Use a distance inside the feasible range, or trim away the tight region."};
    case Status::SelfIntersection:
        return {"self-intersection", "Distant parts of the offset would meet each other.",
                "Use a smaller distance, or split the face."};
    case Status::ToleranceNotReached:
        return {"tolerance-not-reached", "The offset surface could not be brought within the tolerance.",
                "Loosen the tolerance, or allow a higher degree."};
    case Status::EdgeToleranceNotReached:
        return {"edge-tolerance-not-reached", "An edge curve could not be brought within the tolerance.",
                "Loosen the tolerance, or repair the trimming curve at the reported place."};
    case Status::InvalidResult:
        return {"invalid-result", "The offset face did not pass its validity check.",
                "Check the base face; if it is valid, report this as a defect with the file."};
    case Status::KernelError:
        return {"kernel-error", "The geometry kernel raised an error.",
                "Check the base face; if it is valid, report this as a defect with the file."};
    case Status::Cancelled: return {"cancelled", "The computation was cancelled.", "Start it again when ready."};
    }
    return {"unknown", "Unknown status.", "Report this as a defect."};
}

} // namespace

std::string_view name(Status status) { return text(status).name; }
std::string_view sentence(Status status) { return text(status).sentence; }
std::string_view remedy(Status status) { return text(status).remedy; }

std::string_view name(Stage stage)
{
    switch (stage)
    {
    case Stage::Options: return "options";
    case Stage::Input: return "input";
    case Stage::Analysis: return "analysis";
    case Stage::Surface: return "surface";
    case Stage::Extension: return "extension";
    case Stage::Trimming: return "trimming";
    case Stage::Topology: return "topology";
    case Stage::Report: return "report";
    }
    return "unknown";
}

} // namespace laminate_offset
