// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What services, typekits and classes around ports use without including it. See use_everything.hpp.
#ifndef ORO_API_USE_USUAL_HPP
#define ORO_API_USE_USUAL_HPP

namespace PART {

using namespace RTT;

/** The number of what is wrong. */
inline int check() {
    std::stringstream stream;
    std::map<std::string, std::vector<double>> table;
    boost::shared_ptr<int> number(new int(2));
    boost::function<double(double)> root = boost::bind(static_cast<double (*)(double)>(&std::sqrt), _1);
    table["x"].push_back(root(4.0));
    stream << table["x"].front() << *number;
    if (stream.str() != "22") return 1;
    char raw[4];
    memset(raw, 0, sizeof(raw));
    if (strcmp(raw, "") != 0) return 2;
    usleep(1);
    assert(number);
    RTT::log(RTT::Debug) << "checked" << RTT::endlog();
    std::cout << os::TimeService::Instance()->secondsSince(0) << std::endl;
    return 0;
}

}  // namespace PART

#endif
