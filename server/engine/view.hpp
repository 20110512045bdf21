// A stream of frames of one session to one connection: which scene is drawn next, and when.
#pragma once

#include "engine/open_session.hpp"
#include "frames/batches.hpp"
#include "frames/frame_window.hpp"
#include "frames/mailbox.hpp"
#include "frames/picture_detail.hpp"
#include "frames/preview_size.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/pictures/picture_stream.hpp"

#include <map>
#include <memory>
#include <stop_token>

namespace ciel::engine {

enum class Stream { image, geometry };
using wire::MovingCodec; // of interactive pictures; a still is a PNG

// What a worker is asked to show.
struct FrameRequest {
    std::shared_ptr<const sessions::SceneVersion> version;
    geometry::ViewSize size;
    Stream stream = Stream::image;
    bool still = false;
    bool gives_way = false;                // to interactive frames of other views, when it takes long
    double scale = 1;                      // of an interactive picture, which is so much smaller than the view
    wire::PictureStream* moving = nullptr; // the view's, that an interactive picture is one of
    wire::HeldArrays held;                 // of polygons: what the client has
    std::stop_token stop;
    Clock::time_point started;
};

// Thread-safe. The newest scene waits in a mailbox until a worker is free and the window has room for one more frame on
// the way. When nothing newer has come for a moment, the shown picture is followed by its still.
class View : public std::enable_shared_from_this<View> {
public:
    View(std::uint32_t id, std::shared_ptr<OpenSession> session, std::shared_ptr<sessions::Connection> connection,
         const Services& services, geometry::ViewSize size, Stream stream, wire::MovingCodec moving);

    [[nodiscard]] std::uint32_t id() const { return id_; }
    [[nodiscard]] std::uint64_t connection_id() const { return connection_->id; }
    [[nodiscard]] OpenSession& session() const { return *session_; }

    void offer(std::shared_ptr<const sessions::SceneVersion> version);
    void resize(std::uint32_t width, std::uint32_t height, std::optional<double> pixel_ratio); // none: as it was
    void set_stream(Stream stream, std::optional<wire::MovingCodec> moving);                   // none: as it was
    void acknowledge(std::uint32_t frame);                                                     // and all before it
    void look_again(); // the connection has room for frames again
    void close();

    // For the frame loop, which follows a take() that returned something by exactly one of deliver, give_up, give_way
    // and fail.
    [[nodiscard]] std::optional<FrameRequest> take(bool still);
    // Before deliver: what the frame lacks is told when it differs from what the one before lacked. `drawn`: what its
    // drawing added to that; none while something moves: as of the still before, or the sentence would come and go.
    void tell_lacking(const FrameRequest& request, std::vector<std::string> lacking, const geometry::Geometry& geometry,
                      const std::optional<std::vector<std::string>>& drawn);
    // `messages` in order; their headers get the frame number. Empty: nothing new to see. `parts`: of polygons, what
    // the client has when it acknowledges the frame. Without room on the connection the frame is dropped, and made
    // again when there is some. Throws LimitReached beyond the server's memory.
    void deliver(const FrameRequest& request, std::vector<std::vector<std::uint8_t>> messages, wire::ArrayIds parts,
                 const FrameTimes& times);
    void give_up();  // superseded, or nobody waits for it any more
    void give_way(); // and be taken again
    void fail(const FrameRequest& request, const std::string& sentence);

    // True when the last geometry frame had this content, on a grid as fine as this or finer.
    [[nodiscard]] bool shows(const frames::ContentKey& key, double grid);
    // The step of the grid that this content is sent on; none where the client has it on one that is fine enough. Both
    // are remembered as the last geometry frame's.
    [[nodiscard]] std::optional<double> grid_of_new(frames::ContentKey key, double needed);

private:
    void again();  // REQUIRES: the lock; the same scene, because size or stream changed
    void finish(); // REQUIRES: the lock
    [[nodiscard]] wire::PictureStream& pictures_now(); // REQUIRES: the lock, and that none has taken
    void schedule();
    // For one more frame on the way, of the size of the last.
    [[nodiscard]] bool has_room() const { return window_.has_room() && connection_->may_send(frame_bytes_); }
    void make_again_later(const FrameRequest& request); // REQUIRES: the lock

    const std::uint32_t id_;
    const std::shared_ptr<OpenSession> session_;
    const std::shared_ptr<sessions::Connection> connection_;
    const Services& services_;

    std::mutex mutex_;
    geometry::ViewSize size_;
    frames::PreviewSize preview_;
    frames::PictureDetail detail_;
    frames::FrameWindow window_;
    Stream stream_;
    wire::MovingCodec moving_;
    struct {
        wire::MovingCodec codec{};
        int quality = 0;
        std::unique_ptr<wire::PictureStream> stream; // null: none has been asked for
    } pictures_;                                     // for who has taken
    frames::Mailbox<std::shared_ptr<const sessions::SceneVersion>> mailbox_;
    std::shared_ptr<const sessions::SceneVersion> newest_;       // last offered
    std::shared_ptr<const sessions::SceneVersion> still_wanted_; // shown, and no still of it yet
    std::stop_source stop_;                                      // of the work under way
    Clock::time_point started_, quiet_until_;
    bool queued_ = false, working_ = false, working_on_still_ = false, still_queued_ = false, closed_ = false;
    bool gave_up_ = false; // the last interactive frame: the next is not cancelled, or a steady drag would show nothing
    unsigned gave_way_ = 0; // times that the still did that is wanted now
    std::uint32_t sent_ = 0;
    std::size_t frame_bytes_ = 0; // of the last frame
    frames::ContentKey content_;
    double grid_ = 0;                                  // step that content_ was sent on
    std::uint32_t held_ = 0;                           // the frame acknowledged last
    std::map<std::uint32_t, wire::ArrayIds> parts_;    // by frame: the acknowledged one and those after it
    std::vector<std::string> lacking_, drawn_lacking_; // of the last frame, and of the last still
    std::vector<geometry::EmptyLayer> empty_;          // of the last frame
    std::vector<std::string> missing_;                 // layers with places without a value
};

} // namespace ciel::engine
