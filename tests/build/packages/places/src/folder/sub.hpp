#pragma once
namespace places { struct Sub { int c; }; }
