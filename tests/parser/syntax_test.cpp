#include <gtest/gtest.h>
#include <iostream>
#include <fstream>
#include <sstream>
#include "tests/parser/syntax_tree.h"
using namespace lray::test;
TEST(Probe, All) {
    std::ifstream in("/tmp/lray-wt/syntax-probe.txt"); std::string line, text;
    auto flush=[&]{ if(text.empty()) return; Parsed p=parse_text(text); std::cout<<"---\n"<<text<<"=> "<<p.tree<<"\n"<<p.errors; text.clear(); };
    while(std::getline(in,line)){ if(line=="%") flush(); else text+=line+"\n"; } flush();
}
