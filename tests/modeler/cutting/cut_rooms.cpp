#include "tests/modeler/cutting/cut_rooms.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>

#include "modeler/cutting/delaunay_partition.h"
#include "modeler/cutting/diagonal_partition.h"
#include "modeler/cutting/sah_partition.h"
#include "tests/support/room_text.h"
#include "tests/support/shrink_room.h"

namespace enfilade::modeler {

using testing::PartitionVerdict;
using testing::PartitionWish;
using testing::Room;

namespace {

template <PartitionGoal goal>
Partition by_delaunay(const Room& room) {
    return delaunay_partition(room.points, room.sides, goal);
}
Partition by_diagonals(const Room& room) { return diagonal_partition(room.points, room.sides); }
template <PartitionGoal goal>
Partition by_sah(const Room& room) {
    return sah_partition(room.points, room.sides, goal, {});
}

const Cutter table[] = {
    {"delaunay discs", {PartitionGoal::Disc, false}, nullptr, by_delaunay<PartitionGoal::Disc>},
    {"delaunay", {PartitionGoal::Convex, false}, nullptr, by_delaunay<PartitionGoal::Convex>},
    {"diagonals", {PartitionGoal::Convex, false}, &table[0], by_diagonals},
    {"sah discs", {PartitionGoal::Disc, true}, nullptr, by_sah<PartitionGoal::Disc>},
    {"sah", {PartitionGoal::Convex, true}, nullptr, by_sah<PartitionGoal::Convex>},
    {"sah on discs", {PartitionGoal::Convex, true}, &table[3], by_sah<PartitionGoal::Convex>},
};

/// Each piece as a room of its own, the cuts as sides with tags of their own.
std::vector<Room> rooms_of(const Room& room, const Partition& discs) {
    std::vector<Room> rooms(discs.piece_count());
    for (std::uint32_t k = 0; k < discs.piece_count(); ++k) {
        rooms[k].points = room.points;
        rooms[k].points.insert(rooms[k].points.end(), discs.new_points.begin(), discs.new_points.end());
        for (PolygonSide side : discs.piece(k)) {
            if (side.line >= first_cut_line) side.line -= first_cut_line / 2;
            side.tag = std::uint32_t(rooms[k].sides.size());
            rooms[k].sides.push_back(side);
        }
    }
    return rooms;
}

/// What is being cut, for the message of a cutter that aborts or does not end.
struct Running {
    std::string name;
    Room room;
};
Running running;

std::string keep(const Room& room, const std::string& name) {
    std::string file = ::testing::TempDir() + "enfilade-room-" + name + ".txt";
    std::replace(file.begin(), file.end(), ' ', '-');
    std::ofstream out(file);
    write_room(out, room);
    return file;
}

extern "C" void end_of_running(int signal) {
    std::signal(signal, SIG_DFL);
    std::signal(SIGABRT, SIG_DFL);
    std::cerr << (signal == SIGALRM ? "does not end: " : "ends the program: ") << running.name << ", kept in "
              << keep(running.room, running.name) << '\n';
    std::raise(signal == SIGALRM ? SIGABRT : signal);
}

/// Announces what is cut while it lives, and asks that it ends within a minute.
class Watch {
public:
    Watch(std::string name, const Room& room) {
        running = {std::move(name), room};
        for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGALRM}) std::signal(signal, end_of_running);
        alarm(60);
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;
    ~Watch() {
        alarm(0);
        for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGALRM}) std::signal(signal, SIG_DFL);
    }
};

std::size_t reflex_corners(const Room& room) {
    const std::vector<std::uint32_t> ring = simple_ring(room.sides);
    std::size_t count = 0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const PolygonSide &in = room.sides[ring[k]], &out = room.sides[ring[(k + 1) % ring.size()]];
        count += in.line != out.line && orientation(room.points[in.from], room.points[in.to], room.points[out.to]) < 0;
    }
    return count;
}

}  // namespace

std::span<const Cutter> cutters() { return table; }

void Tally::add(const Room& room, const Partition& partition, const PartitionVerdict& verdict) {
    ++rooms;
    pieces += partition.piece_count();
    unused += verdict.unused;
    moved += partition.moved, fallen_back += partition.fallen_back;
    thin_walls += verdict.thin_walls, thin_corners += verdict.thin_corners, thin_cuts += verdict.thin_cuts;
    stray = std::max(stray, verdict.stray), dent = std::max(dent, verdict.dent);
    failures += !verdict.faults.empty();
    if (simple_ring(room.sides).empty()) return;
    ring_pieces += partition.piece_count();
    ring_bound += (reflex_corners(room) + 1) / 2 + 1;
}

void Tally::print(std::string_view family, std::string_view cutter) const {
    std::cout << "rooms | " << family << " | " << cutter << " | " << rooms << " | " << failures << " | " << pieces
              << " | " << (ring_bound ? double(ring_pieces) / double(ring_bound) : 0) << " | " << moved << " | "
              << fallen_back << " | " << thin_walls << " | " << thin_corners << " | " << thin_cuts << " | " << unused
              << " | " << stray << " | " << dent << " |\n";
}

namespace {

/// The first fault without its numbers, so that shrinking keeps to it.
std::string kind_of(const PartitionVerdict& verdict) {
    std::string kind = verdict.faults.empty() ? "" : verdict.faults.front();
    std::erase_if(kind, [](char c) { return std::string_view("0123456789.,-() ").find(c) != std::string_view::npos; });
    return kind;
}

/// Cuts and judges; says what is wrong with a small room that fails alike.
void judge_cut(const Cutter& cutter, const Room& room, const std::string& name, Tally& tally) {
    const Partition partition = cutter.cut(room);
    const PartitionVerdict verdict = judge_partition(room.points, room.sides, partition, cutter.wish);
    tally.add(room, partition, verdict);
    if (verdict.faults.empty() || tally.failures > 3) return;
    const Room least = testing::shrink_room(room, [&](const Room& smaller) {
        if (cutter.discs && simple_ring(smaller.sides).empty()) return false;
        const Watch watch(name + " " + cutter.name + " shrunk", smaller);
        return kind_of(judge_partition(smaller.points, smaller.sides, cutter.cut(smaller), cutter.wish)) ==
               kind_of(verdict);
    });
    const std::string file = keep(least, name + " " + cutter.name);
    ADD_FAILURE() << name << " (" << room.sides.size() << " sides), " << cutter.name << ": " << verdict.text()
                  << "the least room that fails, kept in " << file << ": "
                  << judge_partition(least.points, least.sides, cutter.cut(least), cutter.wish).text()
                  << source_of(least);
}

}  // namespace

void cut_in_every_way(const Room& room, const std::string& name, std::span<Tally> tallies) {
    ASSERT_TRUE(is_sound(room)) << name << " is no room";
    const char* const only = std::getenv("ENFILADE_CUTTER");
    for (std::size_t c = 0; c < cutters().size(); ++c) {
        const Cutter& cutter = cutters()[c];
        if (only && std::string_view(cutter.name).find(only) == std::string_view::npos) continue;
        const Watch watch(name + " " + cutter.name, room);
        if (!cutter.discs) {
            judge_cut(cutter, room, name, tallies[c]);
            continue;
        }
        for (const Room& disc : rooms_of(room, cutter.discs->cut(room))) judge_cut(cutter, disc, name, tallies[c]);
    }
}

}  // namespace enfilade::modeler
