#pragma once
namespace RTT {
template <class T> class OutputPort { T last; };
template <class T> class Property { T value; };
class TaskContext {
public:
    virtual ~TaskContext();
};
}
