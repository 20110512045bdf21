// Keeps the picture of the last frame, so that the next frame clears, reads and converts only the changed tiles.
// Outside the touched tiles the target holds the background and the farthest depth.
#pragma once

#include "render/target/target.hpp"
#include "render/target/touched_tiles.hpp"

namespace server::render {

class KeptPicture {
public:
    KeptPicture(const Gl& gl, Target& target);

    struct Background {
        int width, height, samples;
        std::array<float, 3> top, bottom;
        bool operator==(const Background&) const = default;
    };
    // Binds the target and fills it with the background. `touched`: the tiles on which the frame will draw.
    void begin(const Background& background, const TouchedTiles& touched);
    // Returns the picture, valid until the next begin.
    const Image& read();

private:
    void clear(const std::vector<PixelBox>& boxes);
    void keep_background();

    const Gl& gl_;
    Target& target_;
    GLuint program_ = 0, no_array_ = 0;
    GLint top_ = -1, bottom_ = -1, height_ = -1;
    Background background_{};
    bool is_drawn_ = false;       // true: the target holds background_ outside the tiles of dirty_
    bool is_clean_known_ = false; // true: clean_ is valid, and picture_ equals clean_ outside the tiles of shown_
    TouchedTiles dirty_, shown_, touched_;
    Image clean_, picture_; // picture of the background without a frame; picture of the last frame
};

} // namespace server::render
