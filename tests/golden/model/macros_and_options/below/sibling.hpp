#pragma once
namespace demo { struct Extra { int e; }; }
