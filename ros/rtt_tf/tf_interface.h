// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The operations of a component rtt_tf::RTT_TF, for components that need transforms.
#ifndef RTT_TF_TF_INTERFACE_H
#define RTT_TF_TF_INTERFACE_H

#include <geometry_msgs/TransformStamped.h>
#include <ros/time.h>
#include <rtt/OperationCaller.hpp>
#include <rtt/ServiceRequester.hpp>
#include <rtt/TaskContext.hpp>

#include <string>
#include <vector>

namespace rtt_tf {

/**
 * Callers of the operations of the service `tf` of a component RTT_TF. Make it a member of your component, and connect
 * them in a deployment: `connectServices("yours", "tf")`, where "tf" is the name of the component RTT_TF.
 *
 * Call them only when they are ready(). No call is real-time safe.
 */
class TFInterface {
public:
    /** Adds the callers to the requester `tf` of the component, which must live at least as long. */
    explicit TFInterface(RTT::TaskContext* owner)
        : lookupTransform("lookupTransform"),
          lookupTransformAtTime("lookupTransformAtTime"),
          broadcastTransform("broadcastTransform"),
          broadcastTransforms("broadcastTransforms"),
          broadcastStaticTransform("broadcastStaticTransform"),
          broadcastStaticTransforms("broadcastStaticTransforms"),
          canTransform("canTransform"),
          canTransformAtTime("canTransformAtTime") {
        RTT::ServiceRequester& tf = *owner->requires_("tf");
        tf.addOperationCaller(lookupTransform);
        tf.addOperationCaller(lookupTransformAtTime);
        tf.addOperationCaller(broadcastTransform);
        tf.addOperationCaller(broadcastTransforms);
        tf.addOperationCaller(broadcastStaticTransform);
        tf.addOperationCaller(broadcastStaticTransforms);
        tf.addOperationCaller(canTransform);
        tf.addOperationCaller(canTransformAtTime);
    }
    TFInterface(const TFInterface&) = delete;
    TFInterface& operator=(const TFInterface&) = delete;

    /** True if all eight are connected. */
    bool ready() {
        return lookupTransform.ready() && lookupTransformAtTime.ready() && broadcastTransform.ready() &&
               broadcastTransforms.ready() && broadcastStaticTransform.ready() && broadcastStaticTransforms.ready() &&
               canTransform.ready() && canTransformAtTime.ready();
    }

    typedef const std::string& Frame;
    typedef const geometry_msgs::TransformStamped& Transform;
    typedef const std::vector<geometry_msgs::TransformStamped>& Transforms;

    /** (target, source): brings data of `source` into `target`, at the last time at which that is known. If there is no
        such transform, the result has no frames, and the component logs why. Executed by the caller; does not wait. */
    RTT::OperationCaller<geometry_msgs::TransformStamped(Frame, Frame)> lookupTransform;
    /** The same at a time. Times between two transforms are interpolated. */
    RTT::OperationCaller<geometry_msgs::TransformStamped(Frame, Frame, const ros::Time&)> lookupTransformAtTime;
    /** Executed by the component RTT_TF. What is refused, such as a rotation that is no unit quaternion, is logged. */
    RTT::OperationCaller<void(Transform)> broadcastTransform;
    RTT::OperationCaller<void(Transforms)> broadcastTransforms;
    /** Listeners that come later get all static transforms, too. */
    RTT::OperationCaller<void(Transform)> broadcastStaticTransform;
    RTT::OperationCaller<void(Transforms)> broadcastStaticTransforms;
    /** True if a lookup would succeed. */
    RTT::OperationCaller<bool(Frame, Frame)> canTransform;
    RTT::OperationCaller<bool(Frame, Frame, const ros::Time&)> canTransformAtTime;
};

}  // namespace rtt_tf

#endif
