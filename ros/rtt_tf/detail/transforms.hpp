// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_TF_DETAIL_TRANSFORMS_HPP
#define RTT_TF_DETAIL_TRANSFORMS_HPP

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <rtt/Logger.hpp>
#include <rtt_tf/detail/reported.hpp>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>

namespace tf2 {
class BufferCore;
}

namespace rtt_tf::detail {

/** The transforms that a component has received. Thread-safe; may wait for a lookup in another thread, allocates. */
class Transforms {
public:
    typedef geometry_msgs::TransformStamped Stamped;
    typedef const std::string& Frame;

    /** The name is that of the component, for messages. */
    explicit Transforms(std::string name) : name_(std::move(name)) {}

    /** Begins anew, without transforms. */
    void open(const ros::Duration& cache);
    void close();
    /** Malformed transforms are left out, and logged. Only one thread may call this, open() and forgetMoving(). */
    void insert(const tf2_msgs::TFMessage& message, bool isStatic);
    /** All but static transforms. */
    void forgetMoving();

    /** At time 0: the last one. A transform without frames if there is none; an error says why, once until it works. */
    Stamped lookupAtTime(Frame target, Frame source, const ros::Time& time);
    Stamped lookupLast(Frame target, Frame source) { return lookupAtTime(target, source, ros::Time()); }
    /** The reason is worth a line for debugging only, because programs ask until it works. */
    bool canAtTime(Frame target, Frame source, const ros::Time& time);
    bool canLast(Frame target, Frame source) { return canAtTime(target, source, ros::Time()); }
    /** The last one; the reason is a warning. */
    bool track(Frame target, Frame source, Stamped& result);

private:
    typedef std::shared_ptr<tf2::BufferCore> Buffer;
    /** A kind of use, with what was logged of it. */
    struct Use {
        RTT::LoggerLevel level;
        Reported reported;
    };

    Buffer buffer() const;
    bool isRepeated(const Stamped& transform, bool isStatic);
    bool find(Use& use, Frame target, Frame source, const ros::Time& time, Stamped& result);

    const std::string name_;
    mutable std::mutex mutex_;
    Buffer buffer_;
    std::unordered_map<std::string, ros::Time> newest_;  // of each child that moves
    Reported received_;
    Use lookups_{RTT::Error, {}}, tracks_{RTT::Warning, {}}, questions_{RTT::Debug, {}};
};

}  // namespace rtt_tf::detail

#endif
