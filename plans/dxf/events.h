#pragma once
// What dxflib reports, gathered into blocks of entities.

#include <dl_creationadapter.h>

#include <cstdint>
#include <string>

#include "plans/dxf/entities.h"
#include "plans/dxf/record_source.h"
#include "plans/dxf/words.h"

namespace enfilade::plans::dxf {

/// Listens to dxflib while it reads `source`. What comes between addBlock and endBlock goes to that block, the rest to
/// model space. A second block of one name is not taken: the first one stands. After `most` entities, vertices, layers
/// and blocks nothing more is taken.
class Events : public DL_CreationAdapter {
public:
    Events(Contents& contents, const RecordSource& source, std::size_t most)
        : contents_(contents), source_(source), left_(most) {}

    /// Where the first thing stands that was not taken; 0: everything was.
    [[nodiscard]] int full_line() const { return full_line_; }

    void setVariableString(const std::string& key, const std::string& value, int code) override;
    void setVariableInt(const std::string& key, int value, int code) override;
    void addLayer(const DL_LayerData& data) override;
    void addBlock(const DL_BlockData& data) override;
    void endBlock() override;
    void addLine(const DL_LineData& data) override;
    void addArc(const DL_ArcData& data) override;
    void addCircle(const DL_CircleData& data) override;
    void addEllipse(const DL_EllipseData& data) override;
    void addPolyline(const DL_PolylineData& data) override;
    void addVertex(const DL_VertexData& data) override;
    void addSpline(const DL_SplineData& data) override;
    void addControlPoint(const DL_ControlPointData& data) override;
    void addFitPoint(const DL_FitPointData& data) override;
    void addKnot(const DL_KnotData& data) override;
    void addInsert(const DL_InsertData& data) override;
    void addAttribute(const DL_AttributeData& data) override;
    void addSolid(const DL_SolidData& data) override;
    void addTrace(const DL_TraceData& data) override;
    void add3dFace(const DL_3dFaceData& data) override;
    void addText(const DL_TextData& data) override;
    void addMText(const DL_MTextData& data) override;
    void addMTextChunk(const std::string& text) override;
    void addDimAlign(const DL_DimensionData& data, const DL_DimAlignedData& points) override;
    void addDimLinear(const DL_DimensionData& data, const DL_DimLinearData& points) override;
    void endSequence() override;

private:
    bool spend(std::size_t text_bytes = 0);
    Block& block();
    Shape3* last();
    void add(Shape3 shape);
    void add_face(const DL_TraceData& data, bool in_space);
    [[nodiscard]] std::uint32_t layer_of(const std::string& raw_name);
    [[nodiscard]] std::string dimension_text(const std::string& raw);

    Contents& contents_;
    const RecordSource& source_;
    std::size_t left_;
    int full_line_ = 0;
    Words words_;
    std::size_t block_ = SIZE_MAX;  ///< into the blocks; none: model space
    Block refused_;                 ///< takes the second block of a name
    bool refusing_ = false;
    bool open_ = false;       ///< the last entity takes vertices or attributes
    std::string chunks_;      ///< of an MTEXT that is still to come
    std::string last_layer_;  ///< raw name that was looked up last
    std::uint32_t last_layer_index_ = UINT32_MAX;
};

}  // namespace enfilade::plans::dxf
