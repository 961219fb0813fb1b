#include "gmap/validate.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "gmap/dangling.h"
#include "gmap/scan.h"

namespace enfilade::gmap {

namespace {

using detail::none_u32;
using detail::Reason;
using detail::Scan;
using detail::Suspect;

const char* code_of(Reason reason) {
    switch (reason) {
        case Reason::NoInvolution:
        case Reason::NotCommuting:
        case Reason::TwoIds: return "T1";
        case Reason::Free: return "T2";
        case Reason::ShellNotOrientable:
        case Reason::PieceNotOrientable: return "T3";
        case Reason::FaceManyOrbits:
        case Reason::FaceInOneVolume:
        case Reason::EdgeManyOrbits:
        case Reason::EdgeInOneFace:
        case Reason::EdgeTwiceOnShell: return "T4";
        case Reason::VertexManyOrbits:
        case Reason::VolumeManyOrbits:
        case Reason::VertexTwiceOnShell: return "T5";
        case Reason::DanglingFace:
        case Reason::DanglingEdge:
        case Reason::FewEdges:
        case Reason::FewFaces: return "T6";
        case Reason::ShellEuler:
        case Reason::LinkNoSphere: return "T7";
    }
    return "T1";
}

std::string name_of(const Suspect& suspect) {
    constexpr std::array<const char*, 5> names{"Vertex ", "Edge ", "Face ", "Volume ", "Connected piece "};
    return names[suspect.dimension] + std::to_string(suspect.cell);
}

std::string sentence_of(const Suspect& suspect) {
    const std::string cell = name_of(suspect);
    const std::string dart = "dart " + std::to_string(suspect.dart);
    const std::string alpha = "alpha" + std::to_string(suspect.alpha);
    const std::string value = std::to_string(suspect.value);
    switch (suspect.reason) {
        case Reason::NoInvolution: return cell + ": " + alpha + " of " + dart + " does not lead back to it.";
        case Reason::NotCommuting: {
            constexpr std::array<const char*, 4> pair{"", "alpha1 alpha3", "alpha0 alpha2", "alpha0 alpha3"};
            return cell + ": " + pair[suspect.alpha] + " is no involution at " + dart + ".";
        }
        case Reason::TwoIds: return cell + " and another one share an orbit: " + alpha + " joins them at " + dart + ".";
        case Reason::Free: return cell + " is open: " + dart + " is " + std::to_string(suspect.alpha) + "-free.";
        case Reason::ShellNotOrientable: return cell + " has a shell without inside and outside (not orientable).";
        case Reason::PieceNotOrientable:
            return cell + " of the map is not orientable: a volume meets its mirror image at " + dart + ".";
        case Reason::DanglingFace: return cell + " dangles: it reaches into one volume and ends there.";
        case Reason::FaceManyOrbits: return cell + " has " + value + " sides instead of two.";
        case Reason::FaceInOneVolume: return cell + " has the same volume on both sides.";
        case Reason::DanglingEdge: return cell + " dangles: it reaches into one face and ends there.";
        case Reason::EdgeManyOrbits: return cell + " names several edges that do not hang together.";
        case Reason::EdgeInOneFace: return cell + " has the same face on both sides.";
        case Reason::EdgeTwiceOnShell:
            return cell + " has more than two faces on the shell of volume " + value + ", which touches itself there.";
        case Reason::VertexManyOrbits: return cell + " names several vertices that do not hang together.";
        case Reason::VolumeManyOrbits: return cell + " has a shell in several pieces.";
        case Reason::VertexTwiceOnShell:
            return cell + " has several umbrellas on the shell of volume " + value + ", which touches itself there.";
        case Reason::FewEdges: return cell + " has fewer than three edges (" + value + ").";
        case Reason::FewFaces: return cell + " has fewer than four faces (" + value + ").";
        case Reason::ShellEuler: return cell + " is no ball: V - E + F of its shell is " + value + " instead of 2.";
        case Reason::LinkNoSphere:
            return cell + " breaks V - E + F - C = 0: the cells around it form no sphere (Euler number " + value + ").";
    }
    return cell;
}

/// Judges suspects in order, keeping track of what is blamed. Only maps with a fault get here, so it may take its time.
class Judge {
public:
    Judge(const Map& map, const Scan& found) : map_(map), scan_(found) {
        piece_blamed_.assign(found.piece_count, 0);
        for (std::size_t i = 0; i < 4; ++i) blamed_[i].assign(map.arrays().cell_bound[i], 0);
    }

    Validation run(std::vector<Suspect> suspects) {
        const auto key = [](const Suspect& s) { return std::tuple(s.reason, s.dimension, s.cell, s.dart); };
        std::sort(suspects.begin(), suspects.end(),
                  [&](const Suspect& a, const Suspect& b) { return key(a) < key(b); });
        for (const Suspect& suspect : suspects)
            if (suspect.reason == Reason::VolumeManyOrbits) torn_.insert(suspect.cell);
        const Suspect* before = nullptr;
        for (Suspect& suspect : suspects) {
            const bool is_same = before != nullptr && before->reason == suspect.reason &&
                                 before->dimension == suspect.dimension && before->cell == suspect.cell;
            before = &suspect;
            if (!is_same) judge(suspect);
            if (suspect.reason <= Reason::Free) blame_dart(suspect);
        }
        std::stable_sort(result_.defects.begin(), result_.defects.end(),
                         [](const Defect& a, const Defect& b) { return a.code < b.code; });
        return std::move(result_);
    }

private:
    void judge(Suspect& suspect) {
        if (is_blamed(suspect) || is_torn(suspect)) {
            ++result_.suppressed;
            return;
        }
        blame_cell(suspect);
        report(suspect);
    }

    [[nodiscard]] bool is_blamed(const Suspect& suspect) const {
        return suspect.dimension == 4 ? piece_blamed_[suspect.cell] != 0
                                      : blamed_[suspect.dimension][suspect.cell] != 0;
    }

    /// A volume id with several shells meets itself wherever they touch; that it has several says it all.
    [[nodiscard]] bool is_torn(const Suspect& suspect) const {
        switch (suspect.reason) {
            case Reason::EdgeTwiceOnShell:
            case Reason::VertexTwiceOnShell: return torn_.contains(static_cast<std::uint32_t>(suspect.value));
            case Reason::FaceInOneVolume: return torn_.contains(map_.arrays().cell_id[3][suspect.dart]);
            default: return false;
        }
    }

    void blame_ids(std::uint32_t d) {
        for (std::size_t i = 0; i < 4; ++i) blamed_[i][map_.arrays().cell_id[i][d]] = 1;
    }

    /// The cells at a broken or free dart; where a link is broken, also those it leads to. A piece with a broken link
    /// says nothing about its orientation.
    void blame_dart(const Suspect& suspect) {
        blame_ids(suspect.dart);
        if (suspect.reason == Reason::Free) return;
        for (std::size_t i = 0; i < 4; ++i) blame_ids(map_.arrays().alpha[i][suspect.dart]);
        piece_blamed_[scan_.piece_of_volume[map_.arrays().cell_id[3][suspect.dart]]] = 1;
    }

    /// The cell and what is incident to it; finds a dart of it on the way. A volume stands for itself: to blame all
    /// that touches it would silence most of the map.
    void blame_cell(Suspect& suspect) {
        const MapArrays& arrays = map_.arrays();
        const bool is_piece = suspect.dimension == 4;
        for (std::uint32_t d = 0; d < map_.dart_bound(); ++d) {
            if (!map_.contains(DartId{d})) continue;
            const std::uint32_t of_dart =
                is_piece ? scan_.piece_of_volume[arrays.cell_id[3][d]] : arrays.cell_id[suspect.dimension][d];
            if (of_dart != suspect.cell) continue;
            if (suspect.dart == none_u32) suspect.dart = d;
            if (suspect.dimension != 3) blame_ids(d);
        }
        if (is_piece) piece_blamed_[suspect.cell] = 1;
        else blamed_[suspect.dimension][suspect.cell] = 1;
        if (suspect.reason == Reason::ShellNotOrientable) piece_blamed_[scan_.piece_of_volume[suspect.cell]] = 1;
    }

    void blame_piece(std::uint32_t piece) {
        piece_blamed_[piece] = 1;
        for (const DartId d : map_.darts())
            if (scan_.piece_of_volume[index(map_.volume(d))] == piece) blame_ids(static_cast<std::uint32_t>(d));
    }

    /// The darts of a cell, ascending, from an index made when the first cell of its dimension is blamed.
    std::span<const std::uint32_t> darts_of(std::size_t dimension, std::uint32_t cell) {
        std::vector<std::uint32_t>& first = index_first_[dimension];
        std::vector<std::uint32_t>& items = index_items_[dimension];
        if (first.empty()) {
            const std::vector<std::uint32_t>& ids = map_.arrays().cell_id[dimension];
            first.assign(map_.arrays().cell_bound[dimension] + std::size_t{1}, 0);
            for (const std::uint32_t id : ids)
                if (id != none_u32) ++first[id + 1];
            std::partial_sum(first.begin(), first.end(), first.begin());
            items.resize(map_.dart_count());
            std::vector<std::uint32_t> next = first;
            for (std::uint32_t d = 0; d < ids.size(); ++d)
                if (ids[d] != none_u32) items[next[ids[d]]++] = d;
        }
        return std::span(items).subspan(first[cell], first[cell + 1] - first[cell]);
    }

    void report(const Suspect& suspect) {
        const DartId d{suspect.dart};
        Defect defect{code_of(suspect.reason),
                      static_cast<Blamed>(suspect.dimension),
                      d,
                      map_.vertex(d),
                      map_.edge(d),
                      map_.face(d),
                      map_.volume(d),
                      sentence_of(suspect)};
        switch (defect.blamed) {
            case Blamed::Vertex: defect.vertex = VertexId{suspect.cell}; break;
            case Blamed::Edge: defect.edge = EdgeId{suspect.cell}; break;
            case Blamed::Face: defect.face = FaceId{suspect.cell}; break;
            case Blamed::Volume: defect.volume = VolumeId{suspect.cell}; break;
            case Blamed::Component: break;
        }
        result_.defects.push_back(std::move(defect));
    }

    const Map& map_;
    const Scan& scan_;
    std::array<std::vector<std::uint8_t>, 4> blamed_;
    std::vector<std::uint8_t> piece_blamed_;
    std::set<std::uint32_t> torn_;
    std::array<std::vector<std::uint32_t>, 4> index_first_;
    std::array<std::vector<std::uint32_t>, 4> index_items_;
    Validation result_;
};

void add_self_neighbours(const Map& map, const Scan& found, std::vector<Suspect>& suspects) {
    for (const auto& [face, dart, is_dangling] : detail::judge_faces(map, found.one_volume_darts))
        suspects.push_back({is_dangling ? Reason::DanglingFace : Reason::FaceInOneVolume, 2, 3, face, dart});
    for (const auto& [edge, dart, is_dangling] : detail::judge_edges(map, found.one_face_darts))
        suspects.push_back({is_dangling ? Reason::DanglingEdge : Reason::EdgeInOneFace, 1, 2, edge, dart});
}

void add_bad_links(const Map& map, std::vector<Suspect>& suspects) {
    const std::vector<std::int32_t> euler = detail::link_euler(map);
    const std::vector<DartId> darts = map.representatives<0>();
    for (std::uint32_t v = 0; v < euler.size(); ++v)
        if (darts[v] != none<DartId> && euler[v] != 2)
            suspects.push_back({Reason::LinkNoSphere, 0, 0, v, static_cast<std::uint32_t>(darts[v]), euler[v]});
}

}  // namespace

Validation validate(const Map& map) {
    Scan found = detail::scan(map);
    std::vector<Suspect> suspects = std::move(found.suspects);
    add_self_neighbours(map, found, suspects);
    if (found.euler != 0) add_bad_links(map, suspects);
    if (suspects.empty()) return {};
    return Judge(map, found).run(std::move(suspects));
}

}  // namespace enfilade::gmap
