// A View sends the frames of one session to one connection.
#pragma once

#include "engine/open_session.hpp"
#include "engine/schedule/view_schedule.hpp"
#include "frames/batches.hpp"
#include "frames/congestion_window.hpp"
#include "frames/picture_detail.hpp"
#include "frames/preview_size.hpp"
#include "wire/batches/geometry_batch.hpp"
#include "wire/pictures/picture_stream.hpp"

#include <map>
#include <memory>

namespace server::engine {

enum class Stream { image, geometry };
using wire::MovingCodec; // codec of interactive pictures; a still picture is always a PNG

struct FrameRequest : FrameTurn {
    geometry::ViewSize size;
    Stream stream = Stream::image;
    double scale = 1;                      // side of an interactive picture as a fraction of the view's side
    wire::PictureStream* moving = nullptr; // encoder of interactive pictures; null for other frames
    wire::HeldArrays held;                 // arrays that the client has; geometry stream only
};

// Thread-safe. A frame is due when its ViewSchedule says so, a worker is free, and the window has room for one more
// frame in flight.
class View : public std::enable_shared_from_this<View> {
public:
    View(std::uint32_t id, std::shared_ptr<OpenSession> session, std::shared_ptr<sessions::Connection> connection,
         const EngineServices& services, geometry::ViewSize size, Stream stream, wire::MovingCodec moving);

    [[nodiscard]] std::uint32_t id() const { return id_; }
    [[nodiscard]] std::uint64_t connection_id() const { return connection_->id; }
    [[nodiscard]] OpenSession& session() const { return *session_; }

    void offer(std::shared_ptr<const sessions::SceneVersion> version);
    void resize(std::uint32_t width, std::uint32_t height, std::optional<double> pixel_ratio); // absent: unchanged
    void set_stream(Stream stream, std::optional<wire::MovingCodec> moving);                   // absent: unchanged
    void acknowledge(std::uint32_t frame); // acknowledges earlier frames, too
    void look_again();                     // call this when the connection has room again
    void close();

    // The functions from here to fail() are for the frame loop. take() returns a request if a frame is due. Then
    // exactly one call of deliver, give_up, wait, give_way or fail must follow.
    [[nodiscard]] std::optional<FrameRequest> take(bool still);
    // Notifies the client of missing or incomplete layers of the frame, if they have changed since the last
    // notification. Call it before deliver(). `drawn`: remarks of the renderer, absent for an interactive picture. Then
    // the remarks on the last still picture are kept, because the client's notice would flicker otherwise.
    void tell_lacking(const FrameRequest& request, std::vector<std::string> lacking, const geometry::Geometry& geometry,
                      const std::optional<std::vector<std::string>>& drawn);
    // Sends `messages` with the frame number in each header. `messages` is empty if the client already has the content.
    // `ids`: the arrays that the client has when it acknowledges the frame. If the connection has no room, the frame is
    // dropped and made again later. Throws LimitReached if the frame is larger than the room in the server's memory.
    void deliver(const FrameRequest& request, std::vector<std::vector<std::uint8_t>> messages, wire::ArrayIds ids,
                 const FrameTimes& times);
    void give_up();  // cancelled: the frame was superseded, or the view is closed
    void wait();     // arrays are being read from the source: sends no frame; a new version is offered later
    void give_way(); // the still picture let other views go first; take() returns it again later
    void fail(const FrameRequest& request, const std::string& sentence);

    // Returns whether the last geometry frame had this content, on a grid as fine as `grid` or finer.
    [[nodiscard]] bool shows(const frames::ContentKey& key, double grid);
    // Stores the content, and returns its grid step, or nothing if the client has it on a grid that is fine enough.
    [[nodiscard]] std::optional<double> grid_of_new(frames::ContentKey key, double needed);

private:
    void again(); // makes frames of the same scene again; requires mutex_ to be held
    // Requires mutex_ to be held and no frame in progress.
    [[nodiscard]] wire::PictureStream& pictures_now();
    void post_job(); // posts a job for the next frame if one is due; requires mutex_ to be held
    // Returns whether one more frame may be sent. The frame is assumed to be as large as the last frame.
    [[nodiscard]] bool has_room() const { return window_.has_room() && connection_->may_send(frame_bytes_); }
    void note(const FrameRequest& request, std::size_t bytes, const FrameTimes& times);
    void make_again_later(const FrameRequest& request); // requires mutex_ to be held

    const std::uint32_t id_;
    const std::shared_ptr<OpenSession> session_;
    const std::shared_ptr<sessions::Connection> connection_;
    const EngineServices& services_;

    std::mutex mutex_;
    geometry::ViewSize size_;
    frames::PreviewSize preview_;
    frames::PictureDetail detail_;
    frames::CongestionWindow window_;
    Stream stream_;
    wire::MovingCodec moving_;
    struct {
        wire::MovingCodec codec{};
        int quality = 0;
        std::unique_ptr<wire::PictureStream> stream; // null before the first interactive picture
    } pictures_;                                     // used only by the worker whose take() returned a request
    ViewSchedule schedule_;
    std::uint32_t sent_ = 0;
    std::size_t frame_bytes_ = 0; // size of the last frame's messages
    frames::ContentKey content_;
    double grid_ = 0;                                      // grid step of content_; 0 before the first geometry frame
    std::uint32_t held_ = 0;                               // last acknowledged frame
    std::map<std::uint32_t, wire::ArrayIds> ids_of_frame_; // by frame, from held_ on
    std::vector<std::string> lacking_, drawn_lacking_;     // remarks on the last frame, and on the last still picture
    std::vector<geometry::EmptyLayer> empty_;              // layers of the last frame that show nothing
    std::vector<std::string> missing_;                     // layers of the last frame with values that are not finite
};

} // namespace server::engine
