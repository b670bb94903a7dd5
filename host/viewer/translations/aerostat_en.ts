<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
<context>
    <name>aerostat::viewer::Document</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::MainWindow</name>
    <message numerus="yes">
        <source>%n sample(s) a pixel</source>
        <translation>
            <numerusform>%n sample a pixel</numerusform>
            <numerusform>%n samples a pixel</numerusform>
        </translation>
    </message>
</context>
</TS>
