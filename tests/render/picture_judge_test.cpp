// The judge itself: pictures that are wrong in one way each, and that it must find wrong.
#include "tests/support/picture_judge.h"

#include <gtest/gtest.h>

#include "accel/assemble.h"
#include "render/trace.h"
#include "render/trace_rays.h"
#include "tests/support/coloured_scene.h"
#include "tests/support/synthetic_scene.h"

namespace enfilade::render {
namespace {

using test::PictureVerdict;

class PictureJudging : public testing::Test {
protected:
    PictureJudging()
        : scene_(accel::assemble(
              test::with_own_colours(test::synthetic_office({.rooms_per_row = 3, .rows = 2, .turn = 0.3})))),
          judge_(scene_.view()) {
        camera_.eye = {2, 3, 1.6};
        camera_.target = {0.2, 5.5, 1.2};
        camera_.width = camera_.height = 128;
        frame_ = make_frame(camera_);
        start_ = start_cell(scene_.view(), frame_);
        right_ = picture(camera_);
    }

    [[nodiscard]] Image picture(const Camera& camera) const {
        TraceOptions options;
        options.tracer = Tracer::Scalar;
        options.shading = Shading::Lambert;
        return trace(scene_.view(), camera, options);
    }

    [[nodiscard]] Framebuffer encoded_picture(const Image& image) const {
        Framebuffer framebuffer(image.width, image.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                framebuffer.rgba[static_cast<std::size_t>(y * image.width + x)] = encoded(image.pixel(x, y));
        return framebuffer;
    }

    [[nodiscard]] PictureVerdict judged(const Image& image) const {
        return judge_.compare(frame_, start_, right_, image);
    }
    [[nodiscard]] PictureVerdict judged_encoded(const Image& image) const {
        return judge_.compare(frame_, start_, encoded_picture(right_), encoded_picture(image));
    }

    accel::Scene scene_;
    test::PictureJudge judge_;
    Camera camera_;
    CameraFrame frame_;
    accel::CellId start_;
    Image right_;
};

TEST_F(PictureJudging, AcceptsTheSamePicture) {
    EXPECT_TRUE(judged(right_).is_right()) << judged(right_).text();
    EXPECT_EQ(judged(right_).inside_band, 0u);
    EXPECT_EQ(judged(right_).pixels, 128u * 128u);
    EXPECT_TRUE(judged_encoded(right_).is_right());
}

TEST_F(PictureJudging, FindsOnePixelOfAnotherFace) {
    const accel::SceneView& view = scene_.view();
    for (std::size_t face = 0; face < view.source_face_count(); ++face) {
        const RayHit hit = trace_ray(
            view, {vec_cast<double>(frame_.origin), vec_cast<double>(frame_.direction(64.5f, 64.5f)), start_});
        if (index(hit.source_face) == face) continue;
        Image wrong = right_;
        for (std::size_t k = 0; k < 3; ++k)
            wrong.rgb[3 * (64 * 128 + 64) + k] =
                0.7f * view.materials[index(view.source_faces[face].material)].colour[k];
        EXPECT_EQ(judged(wrong).outside_band, 1u) << "face " << face << ": " << judged(wrong).text();
    }
}

TEST_F(PictureJudging, FindsARayASixteenthOfAPixelAside) {
    Camera beside = camera_;
    beside.target = beside.target + Vec3d{0.002, 0, 0};
    const Image shifted = picture(beside);
    EXPECT_GT(judged(shifted).outside_band, 5u) << judged(shifted).text();
    EXPECT_GT(judged_encoded(shifted).outside_band, 5u) << judged_encoded(shifted).text();
}

TEST_F(PictureJudging, FindsOtherLight) {
    Image brighter = right_;
    for (float& channel : brighter.rgb) channel *= 1.002f;
    EXPECT_GT(judged(brighter).other_shade, 16000u) << judged(brighter).text();
    for (float& channel : brighter.rgb) channel *= 1.02f;
    EXPECT_GT(judged_encoded(brighter).other_shade, 2000u) << judged_encoded(brighter).text();
}

TEST_F(PictureJudging, FindsALeak) {
    Image leaking = right_;
    leaking.rgb[3] = leaking.rgb[5] = 1;
    leaking.rgb[4] = 0;
    EXPECT_EQ(judged(leaking).leaks, 1u);
    EXPECT_EQ(judged_encoded(leaking).leaks, 1u);
}

TEST_F(PictureJudging, FindsABlackPixel) {
    Image black = right_;
    black.rgb[0] = black.rgb[1] = black.rgb[2] = 0;
    EXPECT_FALSE(judged(black).is_right());
    EXPECT_FALSE(judged_encoded(black).is_right());
}

}  // namespace
}  // namespace enfilade::render
