#include <tank/RecorderBase.hpp>
class Recorder : public RecorderBase {
};
