// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ply_region.h"

#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRep_Tool.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace laminate_offset
{
namespace
{

Failure refusal(Status status, std::string message)
{
    return {status, Stage::Trimming, std::move(message), std::nullopt, std::nullopt};
}

//! The face in parts, and where each piece of a boundary comes from.
class FaceCut
{
public:
    FaceCut(const InputFace &input, const std::vector<BoundaryImage> &images) : m_images(images)
    {
        TopTools_ListOfShape face;
        face.Append(input.face);
        TopTools_ListOfShape tools;
        for (const BoundaryImage &image : images)
            for (TopExp_Explorer it(image.wires, TopAbs_EDGE); it.More(); it.Next())
                tools.Append(it.Current());
        m_splitter.SetArguments(face);
        m_splitter.SetTools(tools);
        m_splitter.SetNonDestructive(true);
        m_splitter.Build();
        if (m_splitter.HasErrors())
            return;
        for (const TopoDS_Shape &part : m_splitter.Modified(input.face))
            m_parts.push_back(TopoDS::Face(part.Oriented(TopAbs_FORWARD)));
        for (std::size_t k = 0; k < images.size(); ++k)
            for (TopExp_Explorer it(images[k].wires, TopAbs_EDGE); it.More(); it.Next())
                note(TopoDS::Edge(it.Current()), images[k].keeps_left);
    }

    [[nodiscard]] bool failed() const { return m_splitter.HasErrors(); }

    //! Do more than two pieces of boundaries meet somewhere?
    [[nodiscard]] bool crosses() const
    {
        std::map<const TopoDS_TShape *, std::set<const TopoDS_TShape *>> meeting;
        for (const TopoDS_Face &part : m_parts)
            for (TopExp_Explorer edge(part, TopAbs_EDGE); edge.More(); edge.Next())
                if (is_cut(TopoDS::Edge(edge.Current())))
                    for (TopExp_Explorer end(edge.Current(), TopAbs_VERTEX); end.More(); end.Next())
                        meeting[end.Current().TShape().get()].insert(edge.Current().TShape().get());
        return std::any_of(meeting.begin(), meeting.end(), [](const auto &at) { return at.second.size() > 2; });
    }
    [[nodiscard]] const std::vector<TopoDS_Face> &parts() const { return m_parts; }
    [[nodiscard]] bool is_cut(const TopoDS_Edge &edge) const { return m_kept_left.count(edge.TShape().get()) > 0; }

    //! Does the part lie on the kept side of every boundary that it meets? A boundary that ends inside of it says nothing.
    [[nodiscard]] bool kept(const TopoDS_Face &part) const
    {
        std::map<const TopoDS_TShape *, std::pair<int, int>> votes; // for and against
        for (TopExp_Explorer it(part, TopAbs_EDGE); it.More(); it.Next())
        {
            const auto known = m_kept_left.find(it.Current().TShape().get());
            if (known == m_kept_left.end())
                continue;
            const bool lies_left = it.Current().Orientation() == TopAbs_FORWARD;
            auto &[yes, no] = votes[known->first];
            ++(lies_left == known->second ? yes : no);
        }
        bool any = false;
        for (const auto &[edge, vote] : votes)
        {
            if (vote.first > 0 && vote.second > 0)
                continue;
            if (vote.second > 0)
                return false;
            any = true;
        }
        return any;
    }

private:
    //! Keeps for every piece of the edge whether the ply lies left of the piece's own curve.
    void note(const TopoDS_Edge &edge, bool keeps_left)
    {
        const bool left_of_curve = keeps_left == (edge.Orientation() != TopAbs_REVERSED);
        double first = 0.0;
        double last = 0.0;
        const Handle(Geom_Curve) own = BRep_Tool::Curve(edge, first, last);
        TopTools_ListOfShape pieces = m_splitter.Modified(edge);
        if (pieces.IsEmpty())
            pieces.Append(edge);
        for (const TopoDS_Shape &piece : pieces)
            if (BRep_Tool::Curve(TopoDS::Edge(piece), first, last) == own) // else it is an edge of the face
                m_kept_left[piece.TShape().get()] = left_of_curve;
    }

    const std::vector<BoundaryImage> &m_images;
    BRepAlgoAPI_Splitter m_splitter;
    std::vector<TopoDS_Face> m_parts;
    std::map<const TopoDS_TShape *, bool> m_kept_left;
};

//! The part as a face of its own, standing where the whole face stands.
Result<PlyRegion> region_of(const InputFace &whole, const TopoDS_Face &part, const FaceCut &cut)
{
    Result<InputFace> input = read_face(part);
    if (!input)
        return input.failure();
    PlyRegion region{std::move(input).value(), {}, {}};
    region.input.location = whole.location;
    region.input.reversed = whole.reversed;
    region.input.normal_sign = whole.normal_sign;
    for (std::size_t k = 0; k < region.input.loops.size(); ++k)
        for (std::size_t l = 0; l < region.input.loops[k].curves.size(); ++l)
            if (cut.is_cut(region.input.loops[k].curves[l].edge))
                region.cuts.emplace_back(k, l);
    return region;
}

std::optional<Failure> nothing_cut(const FaceCut &cut)
{
    if (cut.failed())
        return refusal(Status::InvalidFace,
                       "The face could not be split along the boundary; repair the face or redraw the boundary.");
    if (cut.parts().size() < 2)
        return refusal(Status::NotSupported, "The boundary does not cut the face into parts; close it, or extend it "
                                             "past the face's edges. For the whole face leave the boundary out.");
    if (cut.crosses())
        return refusal(Status::NotSupported,
                       "The boundary crosses or touches itself; draw closed curves that keep apart, "
                       "and give plies that overlap a row and a boundary each.");
    return std::nullopt;
}

} // namespace

PlyRegion whole_region(const InputFace &input) { return {input, {}, {}}; }

Result<PlyRegion> cut_region(const InputFace &input, const std::vector<BoundaryImage> &images)
{
    const FaceCut cut(input, images);
    if (std::optional<Failure> refused = nothing_cut(cut))
        return *std::move(refused);
    std::vector<TopoDS_Face> kept;
    for (const TopoDS_Face &part : cut.parts())
        if (cut.kept(part))
            kept.push_back(part);
    if (kept.size() != 1)
        return refusal(Status::NotSupported,
                       kept.empty() ? std::string("The boundary leaves nothing of the face; check its side.")
                                    : fmt::format("The boundary leaves {} separate parts of the face; give each part a "
                                                  "row and a boundary of its own.",
                                                  kept.size()));
    return region_of(input, kept.front(), cut);
}

Result<PlyRegion> cut_region(const InputFace &input, const std::vector<BoundaryImage> &images, const gp_Pnt &kept)
{
    const FaceCut cut(input, images);
    if (std::optional<Failure> refused = nothing_cut(cut))
        return *std::move(refused);
    const TopoDS_Vertex place = BRepBuilderAPI_MakeVertex(kept);
    std::size_t nearest = 0;
    double least = 0.0;
    for (std::size_t k = 0; k < cut.parts().size(); ++k)
    {
        const BRepExtrema_DistShapeShape distance(place, cut.parts()[k]);
        if (!distance.IsDone() || (k > 0 && distance.Value() >= least))
            continue;
        nearest = k;
        least = distance.Value();
    }
    return region_of(input, cut.parts()[nearest], cut);
}

} // namespace laminate_offset
