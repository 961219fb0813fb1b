// FloorspaceJS: a text as it is, or (where it does not begin with a bracket) a recipe for one, so that geometry is
// reached which no mutated text would hold together. Whatever is read is a plan that our own format can hold.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "plans/floorspace/detect.h"
#include "plans/read.h"

namespace {

using enfilade::plans::read_floorspace;
using enfilade::plans::read_json;
using enfilade::plans::write_json;

/// Takes a story out of bytes: few places, so that things coincide; any edges between them, any faces of those.
class Recipe {
public:
    Recipe(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    std::string text() {
        std::string stories;
        const int count = 1 + take() % 2;
        for (int k = 0; k < count; ++k) stories += (k > 0 ? "," : "") + story(k);
        return R"({"project":{"config":{"units":"si"}},"stories":[)" + stories +
               R"(],"window_definitions":[{"id":"0","window_definition_mode":"Single Window","width":1,"height":1},)"
               R"({"id":"1","window_definition_mode":"Repeating Windows","width":0.5,"height":1,"window_spacing":0.3},)"
               R"({"id":"2","window_definition_mode":"Window to Wall Ratio","wwr":0.7,"sill_height":1}],)"
               R"("door_definitions":[{"id":"0","width":0.9,"height":2}]})";
    }

private:
    int take() { return at_ < size_ ? data_[at_++] : 0; }

    static std::string id(int k) { return "\"" + std::to_string(k) + "\""; }

    std::string coordinate() {
        const int byte = take();
        // Whole metres, thirds, and steps about as small as what counts as one place.
        if (byte < 160) return std::to_string(byte % 16);
        if (byte < 208) return std::to_string(byte % 16 / 3.0);
        return std::to_string(byte % 4) + ".000" + std::to_string(byte % 10);
    }

    std::string story(int number) {
        const int vertices = 3 + take() % 14;
        const int edges = 1 + take() % 24;
        std::string text = "{\"id\":" + id(number) + ",\"floor_to_ceiling_height\":" + std::to_string(take() % 5) +
                           ",\"above_ceiling_plenum_height\":" + std::to_string(take() % 7 * 0.02) +
                           ",\"geometry\":{\"vertices\":[";
        for (int k = 0; k < vertices; ++k) {
            text += (k > 0 ? ",{\"id\":" : "{\"id\":") + id(k) + ",\"x\":" + coordinate();
            text += ",\"y\":" + coordinate() + "}";
        }
        text += "],\"edges\":[";
        for (int k = 0; k < edges; ++k) {
            const int byte = take();
            const int from = byte < 128 ? k % vertices : byte % vertices;
            const int to = byte < 128 ? (k + 1 + byte / 96) % vertices : take() % vertices;
            text += (k > 0 ? ",{\"id\":" : "{\"id\":") + id(k) + ",\"vertex_ids\":[" + id(from) + "," + id(to) + "]}";
        }
        text += "],\"faces\":[";
        const int faces = 1 + take() % 4;
        for (int f = 0; f < faces; ++f) text += (f > 0 ? "," : "") + face(f, edges);
        text += "]},\"spaces\":[";
        for (int f = 0; f < faces; ++f)
            text += (f > 0 ? ",{\"face_id\":" : "{\"face_id\":") + id(f) +
                    ",\"open_to_below\":" + (take() % 8 == 0 ? "true" : "false") + "}";
        return text + "]," + apertures("window", 3, edges) + "," + apertures("door", 1, edges) + "}";
    }

    std::string face(int number, int edges) {
        const int first = take() % edges;
        const int length = 3 + take() % 8;
        std::string list, order;
        for (int k = 0; k < length; ++k) {
            const int byte = take();
            list += (k > 0 ? "," : "") + id(byte < 200 ? (first + k) % edges : byte % edges);
            order += (k > 0 ? "," : "") + std::to_string(byte < 240 ? 1 : 0);
        }
        return "{\"id\":" + id(number) + ",\"edge_ids\":[" + list + "],\"edge_order\":[" + order + "]}";
    }

    std::string apertures(const std::string& kind, int definitions, int edges) {
        std::string list;
        const int count = take() % 4;
        for (int k = 0; k < count; ++k)
            list += (k > 0 ? ",{\"" : "{\"") + kind + "_definition_id\":" + id(take() % definitions) +
                    ",\"edge_id\":" + id(take() % edges) + ",\"alpha\":" + std::to_string(take() / 200.0) + "}";
        return "\"" + kind + "s\":[" + list + "]";
    }

    const std::uint8_t* data_;
    std::size_t size_;
    std::size_t at_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    (void)enfilade::plans::is_floorspace(bytes);
    const bool is_text = bytes.starts_with("{");
    const std::string text = is_text ? std::string(bytes) : Recipe(data, size).text();
    std::string once;
    try {
        once = write_json(read_floorspace(text, "fuzz"));
    } catch (const enfilade::InputError& error) {
        if (error.line <= 0 || !is_text) std::abort();
        return 0;
    }
    if (write_json(read_json(once, "again")) != once) std::abort();
    return 0;
}
