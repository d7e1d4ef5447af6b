// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt_tf/detail/transforms.hpp>

#include <rtt_tf/detail/frame_names.hpp>
#include <rtt_tf/detail/transform_check.hpp>
#include <tf2/buffer_core.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <exception>
#include <vector>

namespace rtt_tf::detail {

namespace {

enum Reason : unsigned { NotConfigured = 1, NoName = 2, Unknown = 4, Apart = 8, OtherTime = 16, Other = 32 };
/** Beyond the kinds of Refusal. */
constexpr unsigned kNotTaken = 1024, kRepeated = 2048;
constexpr std::size_t kMostFrames = 20;

std::string knownFrames(const tf2::BufferCore& buffer) {
    std::vector<std::string> frames;
    buffer._getFrameStrings(frames);
    if (frames.empty()) return "no transform has arrived yet";
    std::sort(frames.begin(), frames.end());
    std::string text = "there are ";
    for (std::size_t i = 0; i != std::min(frames.size(), kMostFrames); ++i)
        text += (i == 0 ? "'" : ", '") + frames[i] + '\'';
    if (frames.size() > kMostFrames) text += " and " + std::to_string(frames.size() - kMostFrames) + " more";
    return text;
}

/** The reason why there is none, with its text, which knownFrames() completes if it is Unknown; 0 if there is one. */
unsigned lookup(const tf2::BufferCore* buffer, const std::string& target, const std::string& source,
                const ros::Time& time, geometry_msgs::TransformStamped& result, std::string& why) {
    if (!buffer) {
        why = "the component is not configured";
        return NotConfigured;
    }
    if (target.empty() || source.empty()) {
        why = "the name of a frame is empty";
        return NoName;
    }
    try {
        for (const std::string& frame : {target, source}) {
            if (buffer->_frameExists(frame)) continue;
            why = "frame '" + frame + "' is unknown; ";
            return Unknown;
        }
        result = buffer->lookupTransform(target, source, time);
        return 0;
    } catch (const tf2::ConnectivityException& error) {
        why = error.what();
        return Apart;
    } catch (const tf2::ExtrapolationException& error) {
        why = error.what();
        return OtherTime;
    } catch (const std::exception& error) {
        why = error.what();
        return Other;
    }
}

}  // namespace

void Transforms::open(const ros::Duration& cache) {
    const auto made = std::make_shared<tf2::BufferCore>(cache);
    for (Reported* const each : {&received_, &lookups_.reported, &tracks_.reported, &questions_.reported}) each->clear();
    newest_.clear();
    const std::lock_guard<std::mutex> lock(mutex_);
    buffer_ = made;
}

void Transforms::close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    buffer_.reset();
}

Transforms::Buffer Transforms::buffer() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return buffer_;
}

void Transforms::insert(const tf2_msgs::TFMessage& message, bool isStatic) {
    const Buffer to = buffer();
    if (!to) return;
    for (Stamped one : message.transforms) {
        one.header.frame_id = bare(one.header.frame_id);
        one.child_frame_id = bare(one.child_frame_id);
        std::string why;
        unsigned reason = 0;
        if (const Refusal refusal = check(one)) {
            why = refusal.text;
            reason = refusal.kind;
        } else if (isRepeated(one, isStatic)) {
            why = "the transform to frame '" + one.child_frame_id + "' has the time of the one before";
            reason = kRepeated;
        } else if (!to->setTransform(one, name_, isStatic)) {
            why = "the transform to frame '" + one.child_frame_id + "' is older than cache_time, or was there already";
            reason = kNotTaken;
        }
        if (reason == 0) {
            if (!received_.isEmpty()) received_.works(one.child_frame_id);
        } else if (received_.isNew(one.child_frame_id, reason)) {
            RTT::log(RTT::Warning) << name_ << ": a received transform is ignored: " << why << RTT::endlog();
        }
    }
}

// tf2 ignores them as well, but writes two lines to the console for each.
bool Transforms::isRepeated(const Stamped& transform, bool isStatic) {
    if (isStatic) return false;
    const auto [found, isFirst] = newest_.emplace(transform.child_frame_id, transform.header.stamp);
    if (!isFirst && found->second == transform.header.stamp) return true;
    if (found->second < transform.header.stamp) found->second = transform.header.stamp;
    return false;
}

void Transforms::forgetMoving() {
    newest_.clear();
    if (const Buffer of = buffer()) of->clear();
}

bool Transforms::find(Use& use, Frame target, Frame source, const ros::Time& time, Stamped& result) {
    std::string why;
    const Buffer from = buffer();
    const unsigned reason = lookup(from.get(), bare(target), bare(source), time, result, why);
    if (reason == 0 && use.reported.isEmpty()) return true;
    const std::string subject = target + '\n' + source;
    if (reason == 0)
        use.reported.works(subject);
    else if (use.reported.isNew(subject, reason))
        RTT::log(use.level) << name_ << ": no transform to '" << target << "' from '" << source << "': " << why
                            << (reason == Unknown ? knownFrames(*from) : std::string()) << RTT::endlog();
    return reason == 0;
}

geometry_msgs::TransformStamped Transforms::lookupAtTime(Frame target, Frame source, const ros::Time& time) {
    Stamped result;
    return find(lookups_, target, source, time, result) ? result : Stamped();
}

bool Transforms::canAtTime(Frame target, Frame source, const ros::Time& time) {
    Stamped result;
    return find(questions_, target, source, time, result);
}

bool Transforms::track(Frame target, Frame source, Stamped& result) {
    return find(tracks_, target, source, ros::Time(), result);
}

}  // namespace rtt_tf::detail
