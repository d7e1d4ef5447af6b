// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// boost.serialization of the times in messages.
#ifndef RTT_ROS_BOOST_TIME_H
#define RTT_ROS_BOOST_TIME_H

#include <boost/serialization/nvp.hpp>
#include <boost/serialization/serialization.hpp>
#include <ros/time.h>

namespace boost {
namespace serialization {

template <class Archive>
void serialize(Archive& archive, ros::Time& time, const unsigned) {
    archive& make_nvp("sec", time.sec);
    archive& make_nvp("nsec", time.nsec);
}

template <class Archive>
void serialize(Archive& archive, ros::Duration& duration, const unsigned) {
    archive& make_nvp("sec", duration.sec);
    archive& make_nvp("nsec", duration.nsec);
}

}  // namespace serialization
}  // namespace boost

#endif
