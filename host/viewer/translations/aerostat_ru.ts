<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru">
<context>
    <name>Controls</name>
    <message>
        <source>Biome</source>
        <translation>Биом</translation>
    </message>
    <message>
        <source>Land</source>
        <translation>Земля</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Номер</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Высота</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Изрезанность</translation>
    </message>
    <message>
        <source>Sharpness</source>
        <translation>Острота</translation>
    </message>
    <message>
        <source>Cells per side</source>
        <translation>Ячеек по стороне</translation>
    </message>
    <message>
        <source>Snow line</source>
        <translation>Граница снега</translation>
    </message>
    <message>
        <source>Snow and water</source>
        <translation>Снег и вода</translation>
    </message>
    <message>
        <source>Sea</source>
        <translation>Море</translation>
    </message>
    <message>
        <source>Sea level</source>
        <translation>Уровень моря</translation>
    </message>
    <message>
        <source>Plants</source>
        <translation>Растения</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Густота</translation>
    </message>
    <message>
        <source>Size of plants</source>
        <translation>Рост растений</translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation>Яркость</translation>
    </message>
    <message>
        <source>Soft shadows</source>
        <translation>Мягкие тени</translation>
    </message>
    <message>
        <source>High cloud</source>
        <translation>Перистые облака</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Воздух</translation>
    </message>
    <message>
        <source>Visibility</source>
        <translation>Видимость</translation>
    </message>
    <message>
        <source>Valley fog</source>
        <translation>Туман в долинах</translation>
    </message>
    <message>
        <source>Top of the fog</source>
        <translation>Верх тумана</translation>
    </message>
    <message>
        <source>Visibility in the fog</source>
        <translation>Видимость в тумане</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Воздушный шар</translation>
    </message>
    <message>
        <source>East</source>
        <translation>К востоку</translation>
    </message>
    <message>
        <source>South</source>
        <translation>К югу</translation>
    </message>
    <message>
        <source>Height counts from</source>
        <translation>Высота считается</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Поворот</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Диаметр</translation>
    </message>
    <message>
        <source>Gores</source>
        <translation>Клиньев</translation>
    </message>
    <message>
        <source>Envelope</source>
        <translation>Оболочка</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>Узор</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Цвета</translation>
    </message>
    <message>
        <source>Angle of view</source>
        <translation>Угол зрения</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Затенение</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Картина</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Качество</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Лучей на пиксель</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Экспозиция</translation>
    </message>
    <message>
        <source>Development</source>
        <translation>Проявка</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Фильтр</translation>
    </message>
    <message>
        <source>Erosion</source>
        <translation>Эрозия</translation>
    </message>
    <message>
        <source>Cumulus clouds</source>
        <translation>Кучевые облака</translation>
    </message>
    <message>
        <source>Base of the clouds</source>
        <translation>Основание облаков</translation>
    </message>
    <message>
        <source>Burner</source>
        <translation>Горелка</translation>
    </message>
    <message>
        <source>Palette</source>
        <translation>Палитра</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Объектив</translation>
    </message>
    <message>
        <source>F-number</source>
        <translation>Диафрагма</translation>
    </message>
    <message>
        <source>In focus at</source>
        <translation>Резкость на</translation>
    </message>
    <message>
        <source>Height of parallel view</source>
        <translation>Высота параллельного вида</translation>
    </message>
    <message>
        <source>Single trees up to</source>
        <translation>Отдельные деревья до</translation>
    </message>
    <message>
        <source>Seed of plants</source>
        <translation>Номер растений</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Вид</translation>
    </message>
    <message>
        <source>Shape in detail</source>
        <translation>Форма подробно</translation>
    </message>
    <message>
        <source>Width of ranges</source>
        <translation>Ширина хребтов</translation>
    </message>
    <message>
        <source>Bends</source>
        <translation>Изгибы</translation>
    </message>
    <message>
        <source>Width of bends</source>
        <translation>Ширина изгибов</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Шум</translation>
    </message>
    <message>
        <source>Octaves</source>
        <translation>Октавы</translation>
    </message>
    <message>
        <source>Lacunarity</source>
        <translation>Лакунарность</translation>
    </message>
    <message>
        <source>Ridge offset</source>
        <translation>Сдвиг гребней</translation>
    </message>
    <message>
        <source>Raised by</source>
        <translation>Поднято на</translation>
    </message>
    <message>
        <source>Finer in the middle</source>
        <translation>Мельче в середине</translation>
    </message>
    <message>
        <source>Middle, east</source>
        <translation>Середина, восток</translation>
    </message>
    <message>
        <source>Middle, south</source>
        <translation>Середина, юг</translation>
    </message>
    <message>
        <source>Dunes</source>
        <translation>Дюны</translation>
    </message>
    <message>
        <source>Crest to crest</source>
        <translation>От гребня до гребня</translation>
    </message>
    <message>
        <source>Wind blows towards</source>
        <translation>Ветер дует к</translation>
    </message>
    <message>
        <source>Cover</source>
        <translation>Покров</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Грунт</translation>
    </message>
    <message>
        <source>Cover, second tone</source>
        <translation>Покров, второй тон</translation>
    </message>
    <message>
        <source>Rock</source>
        <translation>Скала</translation>
    </message>
    <message>
        <source>Rock, second tone</source>
        <translation>Скала, второй тон</translation>
    </message>
    <message>
        <source>Rock begins at</source>
        <translation>Скала начинается с</translation>
    </message>
    <message>
        <source>All rock from</source>
        <translation>Сплошная скала с</translation>
    </message>
    <message>
        <source>Beds of rock</source>
        <translation>Слои породы</translation>
    </message>
    <message>
        <source>Width of patterns</source>
        <translation>Ширина узора</translation>
    </message>
    <message>
        <source>Relief in detail</source>
        <translation>Мелкий рельеф</translation>
    </message>
    <message>
        <source>Ripples</source>
        <translation>Рябь</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>Мягкость</translation>
    </message>
    <message>
        <source>Sparkle</source>
        <translation>Блеск</translation>
    </message>
    <message>
        <source>Snow</source>
        <translation>Снег</translation>
    </message>
    <message>
        <source>Snow thins out over</source>
        <translation>Снег редеет на</translation>
    </message>
    <message>
        <source>Full snow up to</source>
        <translation>Сплошной снег до</translation>
    </message>
    <message>
        <source>No snow from</source>
        <translation>Без снега с</translation>
    </message>
    <message>
        <source>Beach</source>
        <translation>Пляж</translation>
    </message>
    <message>
        <source>Beach up to</source>
        <translation>Пляж до</translation>
    </message>
    <message>
        <source>Forest</source>
        <translation>Лес</translation>
    </message>
    <message>
        <source>Forest up to</source>
        <translation>Лес до</translation>
    </message>
    <message>
        <source>Share of forest</source>
        <translation>Доля леса</translation>
    </message>
    <message>
        <source>Width of crowns</source>
        <translation>Ширина крон</translation>
    </message>
    <message>
        <source>Absorption, 1/m</source>
        <translation>Поглощение, 1/м</translation>
    </message>
    <message>
        <source>Sea in detail</source>
        <translation>Море подробно</translation>
    </message>
    <message>
        <source>Deep water</source>
        <translation>Глубокая вода</translation>
    </message>
    <message>
        <source>Sea bed</source>
        <translation>Дно</translation>
    </message>
    <message>
        <source>Longest waves</source>
        <translation>Самые длинные волны</translation>
    </message>
    <message>
        <source>Slope of waves</source>
        <translation>Крутизна волн</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Цвет</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Тени</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Облака</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Толщина</translation>
    </message>
    <message>
        <source>Size of clouds</source>
        <translation>Размер облаков</translation>
    </message>
    <message>
        <source>Seed of clouds</source>
        <translation>Номер облаков</translation>
    </message>
    <message>
        <source>Height of high cloud</source>
        <translation>Высота перистых</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Затенение близким</translation>
    </message>
    <message>
        <source>Light of the sky</source>
        <translation>Свет неба</translation>
    </message>
    <message>
        <source>Occlusion up to</source>
        <translation>На расстоянии до</translation>
    </message>
    <message>
        <source>Bounced light</source>
        <translation>Отражённый свет</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <source>Lamps</source>
        <translation>Лампы</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Сила света</translation>
    </message>
    <message>
        <source>Density of the air</source>
        <translation>Плотность воздуха</translation>
    </message>
    <message>
        <source>Air in detail</source>
        <translation>Воздух подробно</translation>
    </message>
    <message>
        <source>Ozone</source>
        <translation>Озон</translation>
    </message>
    <message>
        <source>Albedo of the land</source>
        <translation>Земля вокруг</translation>
    </message>
    <message>
        <source>Haze thins out over</source>
        <translation>Дымка редеет на</translation>
    </message>
    <message>
        <source>Colour of haze</source>
        <translation>Цветность дымки</translation>
    </message>
    <message>
        <source>Forward scattering</source>
        <translation>Рассеяние вперёд</translation>
    </message>
    <message>
        <source>Albedo of haze</source>
        <translation>Дымка рассеивает</translation>
    </message>
    <message>
        <source>Fog thins out over</source>
        <translation>Туман сходит на нет за</translation>
    </message>
    <message>
        <source>Waves on the fog, height</source>
        <translation>Волны тумана</translation>
    </message>
    <message>
        <source>Waves on the fog, length</source>
        <translation>Ширина волн тумана</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Есть</translation>
    </message>
    <message>
        <source>Albedo</source>
        <translation>Альбедо</translation>
    </message>
    <message>
        <source>Phong coefficients</source>
        <translation>Коэффициенты Фонга</translation>
    </message>
    <message>
        <source>Ambient</source>
        <translation>Фоновый</translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation>Рассеянный</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Зеркальный</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Острота блика</translation>
    </message>
    <message>
        <source>Translucency</source>
        <translation>Просвечивание</translation>
    </message>
    <message>
        <source>Emission</source>
        <translation>Свечение</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Глаз</translation>
    </message>
    <message>
        <source>Camera by numbers</source>
        <translation>Камера в числах</translation>
    </message>
    <message>
        <source>Looks at</source>
        <translation>Смотрит на</translation>
    </message>
    <message>
        <source>Heights count from</source>
        <translation>Высоты отсчитаны от</translation>
    </message>
    <message>
        <source>Upwards</source>
        <translation>Верх</translation>
    </message>
    <message>
        <source>Aperture</source>
        <translation>Отверстие</translation>
    </message>
    <message>
        <source>White balance</source>
        <translation>Баланс белого</translation>
    </message>
    <message>
        <source>Vignette</source>
        <translation>Виньетка</translation>
    </message>
    <message>
        <source>Noise threshold</source>
        <translation>Достаточно при шуме</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>Выборки</translation>
    </message>
    <message>
        <source>Seed of samples</source>
        <translation>Номер выборок</translation>
    </message>
    <message>
        <source>no beach</source>
        <translation>нет пляжа</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Свет</translation>
    </message>
    <message>
        <source>Bounces of light</source>
        <translation>Отражений света</translation>
    </message>
    <message>
        <source>Moon and stars</source>
        <translation>Луна и звёзды</translation>
    </message>
    <message>
        <source>Many balloons</source>
        <translation>Много шаров</translation>
    </message>
    <message>
        <source>Season</source>
        <translation>Время года</translation>
    </message>
    <message>
        <source>Fields</source>
        <translation>Поля</translation>
    </message>
    <message>
        <source>Width of fields</source>
        <translation>Ширина полей</translation>
    </message>
    <message>
        <source>Balloons</source>
        <translation>Число шаров</translation>
    </message>
    <message>
        <source>Seed of balloons</source>
        <translation>Зерно шаров</translation>
    </message>
    <message>
        <source>Middle of balloons, east</source>
        <translation>Середина шаров, восток</translation>
    </message>
    <message>
        <source>Middle of balloons, south</source>
        <translation>Середина шаров, юг</translation>
    </message>
    <message>
        <source>Spread, east to west</source>
        <translation>Разброс с востока на запад</translation>
    </message>
    <message>
        <source>Spread, north to south</source>
        <translation>Разброс с севера на юг</translation>
    </message>
    <message>
        <source>Lowest balloon</source>
        <translation>Самый низкий шар</translation>
    </message>
    <message>
        <source>Highest balloon</source>
        <translation>Самый высокий шар</translation>
    </message>
    <message>
        <source>Distance of balloons</source>
        <translation>Расстояние между шарами</translation>
    </message>
    <message>
        <source>Burners of balloons</source>
        <translation>Горелки шаров</translation>
    </message>
    <message>
        <source>Mood</source>
        <translation>Настроение</translation>
    </message>
    <message>
        <source>Moon</source>
        <translation>Луна</translation>
    </message>
    <message>
        <source>Direction of the moon</source>
        <translation>Направление на луну</translation>
    </message>
    <message>
        <source>Height of the moon</source>
        <translation>Высота луны</translation>
    </message>
    <message>
        <source>Distance of the moon</source>
        <translation>Расстояние до луны</translation>
    </message>
    <message>
        <source>Stars</source>
        <translation>Звёзды</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Широта</translation>
    </message>
    <message>
        <source>Turn of the stars</source>
        <translation>Поворот звёзд</translation>
    </message>
    <message>
        <source>Milky Way</source>
        <translation>Млечный Путь</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Поверхности</translation>
    </message>
    <message>
        <source>Curvature of the Earth</source>
        <translation>Кривизна Земли</translation>
    </message>
    <message>
        <source>Added detail</source>
        <translation>Добавленные детали</translation>
    </message>
    <message>
        <source>Picture on the ground</source>
        <translation>Снимок на земле</translation>
    </message>
    <message>
        <source>Lakes and rivers</source>
        <translation>Озёра и реки</translation>
    </message>
    <message>
        <source>Shadows of the picture lifted</source>
        <translation>Тени на снимке убраны</translation>
    </message>
    <message>
        <source>Passengers</source>
        <translation>Пассажиры</translation>
    </message>
    <message>
        <source>nobody</source>
        <translation>никого</translation>
    </message>
    <message>
        <source>Models from files</source>
        <translation>Модели из файлов</translation>
    </message>
    <message>
        <source>Plants of the biome</source>
        <translation>Растения биома</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Масштаб</translation>
    </message>
    <message>
        <source>Height of the model</source>
        <translation>Высота модели</translation>
    </message>
    <message>
        <source>Upward axis</source>
        <translation>Ось вверх</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Экземпляры</translation>
    </message>
    <message>
        <source>Glare</source>
        <translation>Ореол</translation>
    </message>
</context>
<context>
    <name>NumberBox</name>
    <message>
        <source>Expected a whole number from %1 to %2, without marks.</source>
        <translation>Ожидается целое число от %1 до %2, без знаков.</translation>
    </message>
    <message>
        <source>Expected a number from %1 to %2.</source>
        <translation>Ожидается число от %1 до %2.</translation>
    </message>
    <message>
        <source>The value is still %1.</source>
        <translation>Значение осталось прежним: %1.</translation>
    </message>
</context>
<context>
    <name>Presets</name>
    <message>
        <source>Near the balloon</source>
        <translation>Рядом с шаром</translation>
    </message>
    <message>
        <source>Far, the balloon small</source>
        <translation>Издали, шар маленький</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Сверху</translation>
    </message>
    <message>
        <source>From below</source>
        <translation>Снизу</translation>
    </message>
    <message>
        <source>Against the other side</source>
        <translation>С другой стороны</translation>
    </message>
</context>
<context>
    <name>RenderThread</name>
    <message>
        <source>The device has not answered for %1 s. It may be lost, or busy with other work.</source>
        <translation>Устройство не отвечает уже %1 с. Возможно, оно потеряно или занято другой работой.</translation>
    </message>
</context>
<context>
    <name>Schema</name>
    <message>
        <source>A scene of the renderer aerostat. Lengths are in metres and angles in degrees, and y points upwards. Azimuth 0 is north (-z), and azimuth 90 is east (+x). Values that a file leaves out come from its biome and view.</source>
        <translation>Сцена программы aerostat. Длины в метрах, углы в градусах, y вверх, азимут 0 — север (-z), 90 — восток (+x). Что в файле пропущено, берётся из биома и вида.</translation>
    </message>
    <message>
        <source>Path by which editors find this schema.</source>
        <translation>Где редакторы найдут эту схему.</translation>
    </message>
    <message>
        <source>Version of the format, which is 1.</source>
        <translation>Версия формата: 1.</translation>
    </message>
    <message>
        <source>Kind of landscape, which sets the defaults of terrain, colours, light, sky, air and balloons. It is either a name or an object.</source>
        <translation>Переключатель, который задаёт форму рельефа, цвета, свет, небо, воздух и цвета шара. Либо одно имя, либо объект.</translation>
    </message>
    <message>
        <source>Name of the biome. Everything else has its default.</source>
        <translation>Только имя биома; всё остальное по умолчанию.</translation>
    </message>
    <message>
        <source>The biome with changes to its ground and sea.</source>
        <translation>Биом с изменениями земли и моря.</translation>
    </message>
    <message>
        <source>Colours of the ground, which depend on height, slope and noise. All defaults come with the biome.</source>
        <translation>Как окрашена земля: по высоте, уклону и шуму. Все значения по умолчанию задаёт биом.</translation>
    </message>
    <message>
        <source>First tone of what covers gentle slopes, such as grass or sand, as an albedo. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо первого тона того, что растёт или лежит на пологой земле. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Second tone of what covers gentle slopes, as an albedo. Noise mixes the two tones. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо второго тона; шум смешивает оба. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>First tone of bare rock, as an albedo. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо первого тона голых скал. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Second tone of bare rock, as an albedo. Noise mixes the two tones. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо их второго тона. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Two slopes in degrees, 0 to 90, the smaller one first. Rock begins to show at the first slope, and ground steeper than the second is all rock.</source>
        <translation>Уклоны в градусах, с которого начинаются скалы и выше которого только они, от 0 до 90, сначала меньший.</translation>
    </message>
    <message>
        <source>Albedo of snow. Snow with an albedo above 0.95 clips to white in the picture. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо снега; держите ниже 0,95, иначе он выбелится. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Mean height in metres above which snow lies, -1000000 to 1000000. The value 1000000 means that there is no snow.</source>
        <translation>Средняя высота в метрах, выше которой лежит снег, от -1000000 до 1000000; 1000000 — снега нет.</translation>
    </message>
    <message>
        <source>Height in metres of the zone in which the snow thins out, 0 to 100000.</source>
        <translation>Высота в метрах полосы, в которой снег сходит на нет, от 0 до 100000.</translation>
    </message>
    <message>
        <source>Two slopes in degrees, 0 to 90, the smaller one first. Snow covers all ground up to the first slope, and none stays on ground steeper than the second.</source>
        <translation>Уклоны в градусах, до которого снег сплошной и выше которого он не держится, от 0 до 90, сначала меньший.</translation>
    </message>
    <message>
        <source>Albedo of dry sand at the shore. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо сухого песка на берегу. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Height above the sea up to which sand lies, in metres, -1000000 to 1000000. The value -1000000 means that there is no beach.</source>
        <translation>До этой высоты над морем лежит песок, в метрах, от -1000000 до 1000000; -1000000 — пляжа нет.</translation>
    </message>
    <message>
        <source>Strength of the detail in the surface normal, 0 (none) to 10.</source>
        <translation>Сила деталей в нормали, от 0 (нет) до 10.</translation>
    </message>
    <message>
        <source>Wavelength of wind ripples in metres, 0 (none) to 1000.</source>
        <translation>Длина волны ветровой ряби в метрах, от 0 (нет) до 1000.</translation>
    </message>
    <message>
        <source>Thickness of the largest beds of rock in metres, 0 (none) to 10000.</source>
        <translation>Толщина самых мощных пластов породы в метрах, от 0 (нет) до 10000.</translation>
    </message>
    <message>
        <source>Roughness by which grains of snow or sand reflect light back, 0 (Lambert&apos;s cosine) to 1. The higher it is, the less the brightness depends on the angle to the sun.</source>
        <translation>Насколько ровно светлы снег или песок при любом наклоне к солнцу, ведь зёрна отбрасывают свет назад: от 0 (по Ламберту) до 1.</translation>
    </message>
    <message>
        <source>Strength of the glitter of single grains of snow or sand, 0 (none) to 10.</source>
        <translation>Сила блеска снежинок или песчинок, от 0 (нет) до 10.</translation>
    </message>
    <message>
        <source>Albedo of trees. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо деревьев. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Height in metres up to which trees grow, -100000 to 100000.</source>
        <translation>Высота в метрах, до которой растут деревья, от -100000 до 100000.</translation>
    </message>
    <message>
        <source>Share of the ground below forest_top_m that trees cover, 0 (none) to 1.</source>
        <translation>Доля земли, которую ниже этой высоты покрывают деревья, от 0 (нет) до 1.</translation>
    </message>
    <message>
        <source>Width of the crown of a tree in metres, 0.1 to 1000.</source>
        <translation>Ширина кроны дерева в метрах, от 0,1 до 1000.</translation>
    </message>
    <message>
        <source>The sea: a plane at the height level_m.</source>
        <translation>Море: плоскость на высоте level_m.</translation>
    </message>
    <message>
        <source>Whether there is a sea.</source>
        <translation>Есть ли море.</translation>
    </message>
    <message>
        <source>Height of the plane in metres, -1000000 to 1000000.</source>
        <translation>Высота плоскости в метрах, от -1000000 до 1000000.</translation>
    </message>
    <message>
        <source>Absorption per metre of water by the law of Beer and Lambert, for [red, green, blue], 0 to 100.</source>
        <translation>Поглощение на метр воды по Бугеру — Ламберту — Беру для [красного, зелёного, синего], от 0 до 100.</translation>
    </message>
    <message>
        <source>Colour of deep water. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Цвет глубокой воды. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Albedo of the sand under the water. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо песка под водой. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Wavelength of the largest waves in metres, 0 (excluded) to 10000.</source>
        <translation>Длина самых больших волн в метрах, больше 0 и до 10000.</translation>
    </message>
    <message>
        <source>Root mean square of the slope of the waves, 0 (a mirror) to 1.</source>
        <translation>Среднеквадратичный уклон волн, от 0 (зеркало) до 1.</translation>
    </message>
    <message>
        <source>Seed of the noise, 0 to 4294967295. Each seed gives another landscape.</source>
        <translation>Начальное число шума, от 0 до 4294967295: другое число — другая земля.</translation>
    </message>
    <message>
        <source>Number of quads per side, 2 to 4096.</source>
        <translation>Ячеек по стороне, от 2 до 4096.</translation>
    </message>
    <message>
        <source>Length of a side of the square in metres, 10 to 1000000.</source>
        <translation>Сторона квадрата в метрах, от 10 до 1000000.</translation>
    </message>
    <message>
        <source>Position of the smallest cells, [x, z] in metres. Relief, ground patterns, plants, waves and clouds move with it.</source>
        <translation>[x, z] самых мелких ячеек в метрах. Рельеф, рисунок земли, растения, волны и облака перемещаются вместе с ним.</translation>
    </message>
    <message>
        <source>Size of a cell at the rim divided by that of a cell at the centre, 1 (all cells have the same size) to 1000.</source>
        <translation>Отношение размера ячеек на краю к размеру в середине, от 1 (поровну) до 1000.</translation>
    </message>
    <message>
        <source>Approximate height from the lowest valleys to the highest peaks in metres, 0 to 20000.</source>
        <translation>Примерно от самых низких долин до самых высоких вершин, в метрах, от 0 до 20000.</translation>
    </message>
    <message>
        <source>Height in metres that is added to the whole ground, -100000 to 100000.</source>
        <translation>Прибавка ко всем высотам в метрах, от -100000 до 100000.</translation>
    </message>
    <message>
        <source>Wavelength of the first octave in metres, 1 to 1000000.</source>
        <translation>Длина волны первой октавы в метрах, от 1 до 1000000.</translation>
    </message>
    <message>
        <source>Amplitude of the domain distortion in metres, 0 (none) to 100000.</source>
        <translation>Размах искажения координат в метрах, от 0 (нет) до 100000.</translation>
    </message>
    <message>
        <source>Wavelength of the domain distortion in metres, 1 to 1000000.</source>
        <translation>Длина волны искажения координат в метрах, от 1 до 1000000.</translation>
    </message>
    <message>
        <source>Exponent of the heights, 0.1 to 10. Values above 1 widen the valleys, and values below 1 widen the high ground.</source>
        <translation>Показатель степени высот, от 0,1 до 10: больше 1 расширяет долины, меньше 1 — вершины.</translation>
    </message>
    <message>
        <source>Strength of erosion by water and frost at the scale of the cells, 0 (none) to 1. It makes gullies, channels, and scree at the angle of repose.</source>
        <translation>Сколько вода и мороз сделали с землёй в масштабе её ячеек, от 0 (ничего) до 1: промоины, русла, осыпи под углом естественного откоса.</translation>
    </message>
    <message>
        <source>Sum of octaves of Perlin noise.</source>
        <translation>Октавы шума Перлина.</translation>
    </message>
    <message>
        <source>Method by which the octaves are summed.</source>
        <translation>Как складываются октавы.</translation>
    </message>
    <message>
        <source>Number of octaves, 1 to 20.</source>
        <translation>Число октав, от 1 до 20.</translation>
    </message>
    <message>
        <source>Ratio of the frequencies of successive octaves, 1 to 4.</source>
        <translation>Отношение частот соседних октав, от 1 до 4.</translation>
    </message>
    <message>
        <source>Ratio of the amplitudes of successive octaves, 0 to 8.</source>
        <translation>Отношение амплитуд соседних октав, от 0 до 8.</translation>
    </message>
    <message>
        <source>Offset of ridged noise in (offset - |n|)^2, 0 to 4. Other kinds of noise ignore it.</source>
        <translation>Только для гребневого шума: offset в (offset - |n|)^2, от 0 до 4.</translation>
    </message>
    <message>
        <source>Dunes of wind-blown sand. Only terrain of the kind dunes has them.</source>
        <translation>Навеянный ветром песок, для рельефа dunes.</translation>
    </message>
    <message>
        <source>Distance from crest to crest along the wind in metres, 1 to 100000.</source>
        <translation>От гребня до гребня по ветру, в метрах, от 1 до 100000.</translation>
    </message>
    <message>
        <source>Height of the largest dunes from trough to crest in metres, 0 to 5000.</source>
        <translation>От ложбины до гребня самых больших дюн, в метрах, от 0 до 5000.</translation>
    </message>
    <message>
        <source>Plants and stones on the ground. The biome determines what grows where.</source>
        <translation>Растения и камни на земле; что где растёт, задаёт биом.</translation>
    </message>
    <message>
        <source>Whether there are plants and stones.</source>
        <translation>Стоит ли что-нибудь на земле.</translation>
    </message>
    <message>
        <source>Number of plants per area relative to the usual number of the biome, 0 (none) to 4.</source>
        <translation>Растений на площадь по сравнению с обычным для биома, от 0 (нет) до 4.</translation>
    </message>
    <message>
        <source>Factor on the height of every plant and stone, 0.1 to 10.</source>
        <translation>Множитель высоты всех растений и камней, от 0,1 до 10.</translation>
    </message>
    <message>
        <source>Distance from the camera in metres up to which single trees stand, 10 to 12000. Farther woods are painted on the ground. Smaller plants end at proportionally smaller distances.</source>
        <translation>До какого расстояния от камеры стоят отдельные деревья, в метрах, от 10 до 12000; дальше леса нарисованы на земле. Мелкая растительность кончается во столько же раз ближе.</translation>
    </message>
    <message>
        <source>Seed of the plants, 0 to 4294967295. Each seed places them elsewhere.</source>
        <translation>Другое число — другие растения, от 0 до 4294967295.</translation>
    </message>
    <message>
        <source>Whether there is a balloon.</source>
        <translation>Есть ли шар.</translation>
    </message>
    <message>
        <source>Centre of the floor of the basket. [x, y, z] in metres, y up.</source>
        <translation>Середина пола корзины. [x, y, z] в метрах, y вверх.</translation>
    </message>
    <message>
        <source>Level from which the y of the position is measured: the sea, or the ground below the balloon (the default).</source>
        <translation>От чего считается y положения: от моря (абсолютно) или от земли внизу (по умолчанию).</translation>
    </message>
    <message>
        <source>Largest diameter of the envelope in metres, 2 to 200.</source>
        <translation>Наибольший диаметр оболочки в метрах, от 2 до 200.</translation>
    </message>
    <message>
        <source>Rotation of the whole balloon about its vertical axis in degrees, -360 to 360.</source>
        <translation>Поворот всего шара вокруг оси в градусах, от -360 до 360.</translation>
    </message>
    <message>
        <source>Number of gores of the envelope, 6 to 128.</source>
        <translation>Число клиньев оболочки, от 6 до 128.</translation>
    </message>
    <message>
        <source>Arrangement of the colours on the envelope.</source>
        <translation>Как цвета ложатся на оболочку.</translation>
    </message>
    <message>
        <source>Albedo of one fabric. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо одной ткани. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>The camera.</source>
        <translation>Глаз.</translation>
    </message>
    <message>
        <source>Place where the defaults put the camera: outside the balloon or in its basket.</source>
        <translation>Куда по умолчанию ставится глаз: снаружи шара или в его корзину.</translation>
    </message>
    <message>
        <source>Position of the camera. If it is left out in the view from the basket, the camera stands in the basket at eye height. [x, y, z] in metres, y up.</source>
        <translation>Где находится глаз. При виде из корзины, если не задано, — внутри неё на высоте глаз. [x, y, z] в метрах, y вверх.</translation>
    </message>
    <message>
        <source>Point that is in the middle of the picture. If it is left out in the view from the basket, the camera looks straight ahead. [x, y, z] in metres, y up.</source>
        <translation>Точка в середине картины. При виде из корзины, если не задано, взгляд направлен прямо вперёд. [x, y, z] в метрах, y вверх.</translation>
    </message>
    <message>
        <source>Level from which the y of position and target is measured: the sea, the ground below each of them, or the floor of the balloon&apos;s basket (the default).</source>
        <translation>От чего считаются y положения и цели: от моря (абсолютно), от земли под каждой или от пола корзины шара (по умолчанию).</translation>
    </message>
    <message>
        <source>Direction that points upwards in the picture. Its length does not matter but must not be 0. If the camera looks along it, y points upwards instead. In a view straight down, north is at the top of the picture, and in a view straight up, south is. Components are -1000 to 1000.</source>
        <translation>Направление, которое на картине смотрит вверх; длина не важна, но не 0. Если взгляд идёт вдоль него, вверх смотрит y; при взгляде прямо вниз наверху картины север, прямо вверх - юг. Компоненты от -1000 до 1000.</translation>
    </message>
    <message>
        <source>With pinhole, everything is sharp. With thin_lens, one distance is sharp. A panorama shows all directions, 360 degrees across and 180 degrees down. It suits a picture twice as wide as high, and only the azimuth of its target matters. With orthographic, parallel rays start at the plane through the position, and plants stand around the target.</source>
        <translation>pinhole: всё резко. thin_lens: резко лишь на одной глубине. panorama: все направления, 360 градусов вширь и 180 ввысь, лучше всего при ширине вдвое больше высоты; у цели важен только азимут. orthographic: параллельные лучи из плоскости через положение, растения стоят вокруг цели.</translation>
    </message>
    <message>
        <source>Vertical angle of view of pinhole and thin_lens in degrees, 1 to 170.</source>
        <translation>Угол зрения по вертикали в градусах для pinhole и thin_lens, от 1 до 170.</translation>
    </message>
    <message>
        <source>F-number of thin_lens, 0.1 to 1000: its focal length divided by the diameter of its aperture. The focal length follows from fov_y_deg with a sensor 24 mm high.</source>
        <translation>Для thin_lens: отношение фокусного расстояния (какого требует fov_y_deg при матрице высотой 24 мм) к диафрагме, от 0,1 до 1000.</translation>
    </message>
    <message>
        <source>Diameter of the aperture of thin_lens in metres, 0 to 1000. If it is left out, it follows from f_number.</source>
        <translation>Для thin_lens: диаметр диафрагмы в метрах, от 0 до 1000; если не задан, его определяет f_number.</translation>
    </message>
    <message>
        <source>Distance along the axis at which thin_lens is in focus, in metres, 0.01 to 1000000. If it is left out, the target is in focus.</source>
        <translation>Для thin_lens: расстояние до плоскости резкости в метрах вдоль оси, от 0,01 до 1000000; если не задано, резка цель.</translation>
    </message>
    <message>
        <source>Height of what orthographic shows, from the bottom to the top of the picture, in metres, 0.001 to 1000000.</source>
        <translation>Для orthographic: метров от низа до верха картины, от 0,001 до 1000000.</translation>
    </message>
    <message>
        <source>The sun. Its position is given by its direction, by its two angles, or by date, time, latitude and longitude.</source>
        <translation>Солнце. Задайте его направление, или два угла, или дату, время, широту и долготу.</translation>
    </message>
    <message>
        <source>Direction towards the sun. Its length does not matter but must not be 0. Components are -1000000 to 1000000.</source>
        <translation>Направление на солнце; длина любая, кроме 0. Компоненты от -1000000 до 1000000.</translation>
    </message>
    <message>
        <source>Azimuth of the sun in degrees, -360 to 360. North (-z) is 0, and east (+x) is 90.</source>
        <translation>Азимут в градусах, 0 — север (-z), 90 — восток (+x), от -360 до 360.</translation>
    </message>
    <message>
        <source>Height of the sun above the horizon in degrees, -90 to 90.</source>
        <translation>Высота над горизонтом в градусах, от -90 до 90.</translation>
    </message>
    <message>
        <source>Date for which the position of the sun is computed, such as 2024-06-21.</source>
        <translation>День, в который оно стоит именно так, например 2024-06-21.</translation>
    </message>
    <message>
        <source>Time for which the position of the sun is computed, such as 06:30 or 06:30:15. It is universal time unless an offset follows, as in 06:30+02:00.</source>
        <translation>Время того дня, например 06:30 или 06:30:15; всемирное, если не указан сдвиг: 06:30+02:00.</translation>
    </message>
    <message>
        <source>Latitude of the place in degrees, positive to the north, -90 to 90.</source>
        <translation>Широта места в градусах, северная положительна, от -90 до 90.</translation>
    </message>
    <message>
        <source>Longitude of the place in degrees, positive to the east, -180 to 180.</source>
        <translation>Долгота места в градусах, восточная положительна, от -180 до 180.</translation>
    </message>
    <message>
        <source>Colour of the sunlight outside the atmosphere. The largest component should be 1. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Цвет света вне атмосферы; наибольшая компонента должна быть 1. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Irradiance of a plane that faces the sun outside the atmosphere, 0 to 1000.</source>
        <translation>Освещённость обращённой к солнцу площадки вне атмосферы, от 0 до 1000.</translation>
    </message>
    <message>
        <source>Whether the sun casts shadows.</source>
        <translation>Отбрасывает ли тени.</translation>
    </message>
    <message>
        <source>Whether the light casts shadows.</source>
        <translation>Отбрасывает ли тени.</translation>
    </message>
    <message>
        <source>Whether the shadows of the sun have soft edges, because the sun is a disc. If it is left out, the quality decides.</source>
        <translation>Мягки ли края теней, как от солнечного диска. Если не задано, решает качество.</translation>
    </message>
    <message>
        <source>Point lights, at most 16.</source>
        <translation>Точечные источники света, не больше 16.</translation>
    </message>
    <message>
        <source>A point light.</source>
        <translation>Точечный источник света.</translation>
    </message>
    <message>
        <source>Colour of the light. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Цвет света. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Irradiance times the square of the distance in metres, 0 to 1000000000.</source>
        <translation>Освещённость, умноженная на квадрат расстояния в метрах, от 0 до 1000000000.</translation>
    </message>
    <message>
        <source>Clouds, and the light that comes from the sky.</source>
        <translation>Что есть на небе, кроме солнца и воздуха.</translation>
    </message>
    <message>
        <source>Share of the sky that thin, high clouds cover, 0 to 1.</source>
        <translation>Доля неба под тонкими высокими облаками, от 0 до 1.</translation>
    </message>
    <message>
        <source>Height of the thin, high clouds above the camera in metres, 100 to 100000.</source>
        <translation>Высота облаков над глазом в метрах, от 100 до 100000.</translation>
    </message>
    <message>
        <source>Whether nearby surfaces block the light of the sky (ambient occlusion). If it is left out, the quality decides.</source>
        <translation>Заслоняет ли близкое свет неба. Если не задано, решает качество.</translation>
    </message>
    <message>
        <source>Distance in metres up to which surfaces block the light of the sky, 0.01 to 100000. Farther surfaces block less of it.</source>
        <translation>На каком расстоянии оно ещё заслоняет, в метрах, от 0,01 до 100000; чем дальше, тем слабее.</translation>
    </message>
    <message>
        <source>The gases of the air and the ground under it. The colours of sky, sunlight and distance follow from them.</source>
        <translation>Газы воздуха и земля под ним: от них цвет неба, солнечного света и дали.</translation>
    </message>
    <message>
        <source>Density of the molecules relative to that of the Earth&apos;s air, 0 (none) to 10.</source>
        <translation>Плотность молекул относительно земной, от 0 (нет) до 10.</translation>
    </message>
    <message>
        <source>Amount of ozone in Dobson units, 0 to 3000.</source>
        <translation>Озон в единицах Добсона, от 0 до 3000.</translation>
    </message>
    <message>
        <source>Mean albedo of the land around. The air scatters the light that the land reflects. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо земли вокруг, свет которой воздух отражает обратно. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Droplets and dust in the air, which thin out with height. Together with the molecules, their extinction at sea level is 3.912 / visibility_m.</source>
        <translation>Капли и пыль в воздухе: вместе с молекулами ослабление 3,912 / видимость на уровне моря, с высотой убывает.</translation>
    </message>
    <message>
        <source>Distance in metres at which contrast falls to 2 %, 10 to 10000000.</source>
        <translation>Расстояние в метрах, на котором контраст падает до 2 %, от 10 до 10000000.</translation>
    </message>
    <message>
        <source>Height in metres over which the density of the haze falls to 1/e, 1 to 1000000.</source>
        <translation>Высота в метрах, на которой дымка слабеет в e раз, от 1 до 1000000.</translation>
    </message>
    <message>
        <source>Angstrom exponent, -1 to 4: the extinction is proportional to the wavelength to the power of minus this value. It is 0 (grey) for fog, 0.3 for dust and 1.3 for fine haze. If it is left out, it falls to 0 as the visibility falls from 6 km to 500 m.</source>
        <translation>Ослабление идёт как длина волны в степени минус это число, от -1 до 4: 0 (серое) для тумана, 0,3 для пыли, 1,3 для тонкой дымки. Если не задано, падает до 0, когда видимость падает от 6 км до 500 м.</translation>
    </message>
    <message>
        <source>Mean cosine of the angle by which haze scatters light, 0 (equal in all directions) to 0.95 (forwards).</source>
        <translation>Средний косинус угла отклонения света, от 0 (равномерно) до 0,95 (вперёд).</translation>
    </message>
    <message>
        <source>Share of the extinction that is scattering. The rest is absorption. [red, green, blue], each 0 to 1. If it is left out, it rises towards 1 as the visibility falls below 6 km.</source>
        <translation>Доля рассеяния в ослаблении, остальное поглощается. [красный, зелёный, синий], каждый от 0 до 1. Если не задана, растёт к 1, когда видимость падает ниже 6 км.</translation>
    </message>
    <message>
        <source>Fog that fills the valleys. It is equally dense up to its top.</source>
        <translation>Туман, который заполняет долины, ровный до самого верха.</translation>
    </message>
    <message>
        <source>Whether there is fog.</source>
        <translation>Есть ли туман.</translation>
    </message>
    <message>
        <source>Distance in metres at which contrast inside the fog falls to 2 %, 10 to 1000000.</source>
        <translation>Расстояние в метрах, на котором контраст внутри него падает до 2 %, от 10 до 1000000.</translation>
    </message>
    <message>
        <source>Mean height of the top of the fog above the sea in metres, -100000 to 100000.</source>
        <translation>Средняя высота его верха над морем в метрах, от -100000 до 100000.</translation>
    </message>
    <message>
        <source>Height in metres over which the fog thins out at its top, 1 to 10000.</source>
        <translation>Высота в метрах, на которой он рассеивается, от 1 до 10000.</translation>
    </message>
    <message>
        <source>Height of the waves at the top of the fog in metres, 0 (level) to 10000.</source>
        <translation>Насколько его верх поднимается и опускается, в метрах, от 0 (ровный) до 10000.</translation>
    </message>
    <message>
        <source>Length of the waves at the top of the fog in metres, 10 to 100000.</source>
        <translation>Длина волны подъёмов и спусков его верха в метрах, от 10 до 100000.</translation>
    </message>
    <message>
        <source>Shading over a triangle: flat is the same everywhere, gouraud interpolates colours, and phong (the default) interpolates normals.</source>
        <translation>Как меняются нормали и цвета по треугольнику: никак, интерполяция цветов или интерполяция нормалей (по умолчанию).</translation>
    </message>
    <message>
        <source>Sets /image/spp, /image/adaptive_threshold, /sun/soft_shadows and /sky/ambient_occlusion where the scene leaves them out. Their values are 1, 0, false, false with draft, 4, 0, true, true with standard (the default), and 256, 0.008, true, true with final.</source>
        <translation>Задаёт /image/spp, /image/adaptive_threshold, /sun/soft_shadows и /sky/ambient_occlusion, если их нет в сцене: draft — 1, 0, false, false; standard (по умолчанию) — 4, 0, true, true; final — 256, 0.008, true, true.</translation>
    </message>
    <message>
        <source>The picture.</source>
        <translation>Картина.</translation>
    </message>
    <message>
        <source>Width in pixels, 1 to 32768.</source>
        <translation>Ширина в пикселях, от 1 до 32768.</translation>
    </message>
    <message>
        <source>Height in pixels, 1 to 32768.</source>
        <translation>Высота в пикселях, от 1 до 32768.</translation>
    </message>
    <message>
        <source>Seed of the samples, 0 to 4294967295.</source>
        <translation>Начальное число выборок, от 0 до 4294967295.</translation>
    </message>
    <message>
        <source>Reconstruction filter of the pixels.</source>
        <translation>Фильтр восстановления.</translation>
    </message>
    <message>
        <source>Exposure in stops, -30 to 30. Each stop doubles the brightness. If it is left out, it is metered in the picture, and dusk and night stay dark.</source>
        <translation>Экспозиция в ступенях: каждая удваивает яркость, от -30 до 30. Если не задана, следует из картины, а сумерки и ночь остаются тёмными.</translation>
    </message>
    <message>
        <source>Phong coefficients of one material.</source>
        <translation>Коэффициенты Фонга одного предмета.</translation>
    </message>
    <message>
        <source>Factor on the light of the sky, 0 to 10.</source>
        <translation>Множитель света неба, от 0 до 10.</translation>
    </message>
    <message>
        <source>Factor on the diffuse reflection (Lambert&apos;s cosine), 0 to 10.</source>
        <translation>Множитель слагаемого Ламберта, от 0 до 10.</translation>
    </message>
    <message>
        <source>Factor on the specular highlight, 0 to 10.</source>
        <translation>Множитель блика, от 0 до 10.</translation>
    </message>
    <message>
        <source>Exponent of the specular highlight, 1 to 10000.</source>
        <translation>Показатель степени блика, от 1 до 10000.</translation>
    </message>
    <message>
        <source>Share of the light on the far side that shines through the surface, 0 to 1.</source>
        <translation>Доля света с обратной стороны, которая проходит насквозь, от 0 до 1.</translation>
    </message>
    <message>
        <source>Light that the surface emits. It is multiplied by the colours of the vertices. Linear Rec. 709 [red, green, blue], each 0 to 1000000.</source>
        <translation>Собственный свет, умноженный на цвет вершин. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1000000.</translation>
    </message>
    <message>
        <source>Whether surfaces that block the light of the sky reflect sunlight in its place.</source>
        <translation>Посылает ли то, что заслоняет свет неба, вместо него отражённый солнечный свет.</translation>
    </message>
    <message>
        <source>Cumulus clouds with flat bases. They cast shadows on the land.</source>
        <translation>Кучевые облака с плоским основанием. Их тени падают на землю.</translation>
    </message>
    <message>
        <source>Share of the sky straight above that the clouds cover, 0 (none) to 1.</source>
        <translation>Доля неба прямо над головой, которую они закрывают, от 0 (нет) до 1.</translation>
    </message>
    <message>
        <source>Height of the bases of the clouds above the sea in metres, 0 to 20000.</source>
        <translation>Высота их оснований над морем в метрах, от 0 до 20000.</translation>
    </message>
    <message>
        <source>Height of tall clouds from base to top in metres, 10 to 10000. Greater heights than 1.5 times size_m are reduced to that.</source>
        <translation>От оснований до высоких вершин в метрах, от 10 до 10000; считается не больше полуторного size_m.</translation>
    </message>
    <message>
        <source>Width of a cloud in metres, 10 to 20000.</source>
        <translation>Ширина одного облака в метрах, от 10 до 20000.</translation>
    </message>
    <message>
        <source>Seed of the clouds, 0 to 4294967295. Each seed gives other clouds.</source>
        <translation>Другое число — другие облака, от 0 до 4294967295.</translation>
    </message>
    <message>
        <source>Further balloons, at most 32. Each is built with as much detail as its size in the picture requires.</source>
        <translation>Другие шары, не больше 32; каждый построен настолько подробно, насколько он велик на картине.</translation>
    </message>
    <message>
        <source>A hot-air balloon. In an EXR file, all balloons have the same object ids for their parts.</source>
        <translation>Воздушный шар. У всех шаров номера частей в EXR общие.</translation>
    </message>
    <message>
        <source>Strength of the burners, 0 (no flame) to 1. Their light fills the envelope.</source>
        <translation>Как сильно горят горелки, от 0 (без пламени) до 1; их свет заполняет оболочку.</translation>
    </message>
    <message>
        <source>Set of fabric colours that go together. If it is left out, the biome chooses it, and further balloons use the sets in turn.</source>
        <translation>Ткани, которые подходят друг другу. Если не задано, выбирает биом; другие шары чередуют их.</translation>
    </message>
    <message>
        <source>Colours of the fabric, which replace those of the palette, 1 to 64 of them. The pattern repeats them.</source>
        <translation>Цвета ткани вместо палитры, от 1 до 64; узор повторяет их.</translation>
    </message>
    <message>
        <source>Number of samples per pixel, 1 to 65536. If adaptive_threshold is above 0, it is the largest number.</source>
        <translation>Лучей на пиксель, от 1 до 65536; при adaptive_threshold больше 0 — самое большее.</translation>
    </message>
    <message>
        <source>Noise at which a pixel needs no more samples, as a share of the range from black to white on a display, 0 (all pixels get spp samples) to 1. It is estimated from 16 samples on.</source>
        <translation>Начиная с 16 лучей пикселю, шум которого оценён меньше этой доли пути от чёрного до белого на экране, их достаточно; от 0 (все получают spp) до 1.</translation>
    </message>
    <message>
        <source>Colour temperature in kelvins of the light that looks white in the picture, 1700 to 25000. The value 6504 changes nothing. If it is left out, it goes half of the way to the daylight of the scene.</source>
        <translation>Цветовая температура света, который выйдет белым, в кельвинах, от 1700 до 25000; 6504 ничего не меняет. Если не задана, проходит полпути до дневного света сцены.</translation>
    </message>
    <message>
        <source>Share of the light that is lost in the corners of the picture, 0 (none) to 0.9. The loss grows by the fourth power of a cosine.</source>
        <translation>Доля света, которая теряется в углах картины, по четвёртой степени косинуса, от 0 (нет) до 0,9.</translation>
    </message>
    <message>
        <source>Strength of the glare, 0 (none) to 1: the light that a lens scatters around what is far brighter than white, such as the sun. A part of a picture has the glare of its own light alone, and an EXR file has none.</source>
        <translation>Сила ореола, от 0 (нет) до 1: это свет, который объектив рассеивает вокруг того, что намного ярче белого, например солнца. У части картины ореол лишь от её собственного света, а в файле EXR его нет.</translation>
    </message>
    <message>
        <source>Largest wavelength of the detail in colour and relief in metres, 0 (excluded) to 100000.</source>
        <translation>Наибольшая длина волны деталей цвета и рельефа, в метрах, больше 0 и до 100000.</translation>
    </message>
    <message>
        <source>How light is found. local (the default) adds up what each surface gets from sun, sky and lamps. path follows light from surface to surface, so that surfaces light each other, and takes longer.</source>
        <translation>Как находится свет. local (по умолчанию) складывает то, что каждая поверхность получает от солнца, неба и ламп. path прослеживает свет от поверхности к поверхности, так что поверхности освещают друг друга; это дольше.</translation>
    </message>
    <message>
        <source>How often a path of light may go on from one surface to another, 0 (surfaces get light straight from sun, sky and lamps alone) to 64.</source>
        <translation>Сколько раз путь света может продолжиться от одной поверхности к другой, от 0 (поверхности получают свет только прямо от солнца, неба и ламп) до 64.</translation>
    </message>
    <message>
        <source>Season of a meadow, which sets the defaults of grass, fields and leaves: spring, summer (the default) or autumn, in which larches and birches are golden. Other biomes have none.</source>
        <translation>Время года на лугах, от которого зависят обычные цвета травы, полей и листвы: spring (весна), summer (лето, по умолчанию) или autumn (осень), когда лиственницы и берёзы золотые. В других биомах его нет.</translation>
    </message>
    <message>
        <source>Albedo of ripe corn and stubble on fields. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо спелых хлебов и стерни на полях. Линейные Rec. 709: [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Width of the fields on gentle ground in metres, 0 (none) to 10000.</source>
        <translation>Ширина полей на пологой земле в метрах, от 0 (нет) до 10000.</translation>
    </message>
    <message>
        <source>Balloons that are made from a seed, after those of /balloons. Their places, sizes, patterns, palettes and flames differ.</source>
        <translation>Шары, которые создаются из зерна в дополнение к /balloons. Их места, размеры, узоры, палитры и огни различаются.</translation>
    </message>
    <message>
        <source>Number of balloons, 0 (none) to 32. There are at most 33 balloons in all. Where the area has no room for so many, there are fewer.</source>
        <translation>Число шаров, от 0 (нет) до 32. Всего шаров не больше 33. Если им не хватает места, их меньше.</translation>
    </message>
    <message>
        <source>Seed of the balloons, 0 to 4294967295.</source>
        <translation>Зерно шаров, от 0 до 4294967295.</translation>
    </message>
    <message>
        <source>Middle of the area above which they fly, [x, z] in metres.</source>
        <translation>Середина местности, над которой они летят, [x, z] в метрах.</translation>
    </message>
    <message>
        <source>Half of the width of the area along x and along z in metres.</source>
        <translation>Половина ширины этой местности вдоль x и вдоль z в метрах.</translation>
    </message>
    <message>
        <source>Height of the lowest basket above the ground in metres, 0 to 10000.</source>
        <translation>Высота самой низкой корзины над землёй в метрах, от 0 до 10000.</translation>
    </message>
    <message>
        <source>Height of the highest basket above the ground in metres, 0 to 10000.</source>
        <translation>Высота самой высокой корзины над землёй в метрах, от 0 до 10000.</translation>
    </message>
    <message>
        <source>Least distance between two balloons in metres, 0 to 10000.</source>
        <translation>Наименьшее расстояние между двумя шарами в метрах, от 0 до 10000.</translation>
    </message>
    <message>
        <source>Greatest strength of the burners, 0 to 1. At a value above 0, two of three balloons burn, each with at least half of this strength.</source>
        <translation>Наибольшая сила горелок, от 0 до 1. При значении больше 0 горят два шара из трёх, каждый не слабее половины этой силы.</translation>
    </message>
    <message>
        <source>Time of day or weather. It sets defaults of sun, moon, air, clouds and film that go before those of the biome. Values that a file gives win over it. none (the default) leaves all as the biome has it.</source>
        <translation>Время суток или погода. Задаёт вместо биома обычные значения солнца, луны, воздуха, облаков и плёнки. Значения из файла важнее. none (по умолчанию) оставляет всё, как в биоме.</translation>
    </message>
    <message>
        <source>The moon. Its phase follows from where moon and sun stand. It lights the land when the sun is lower than 4 degrees below the horizon. If the sun is given by date, time and place, what is left out here is the real moon&apos;s.</source>
        <translation>Луна. Её фаза следует из положений луны и солнца. Она освещает землю, когда солнце опустилось ниже 4 градусов под горизонт. Если солнце задано датой, временем и местом, то всё, что здесь не указано, берётся от настоящей луны.</translation>
    </message>
    <message>
        <source>Whether there is a moon.</source>
        <translation>Есть ли луна.</translation>
    </message>
    <message>
        <source>Azimuth of the moon in degrees, -360 to 360. North (-z) is 0, and east (+x) is 90.</source>
        <translation>Азимут луны в градусах, от -360 до 360. Север (-z) — 0, восток (+x) — 90.</translation>
    </message>
    <message>
        <source>Height of the moon above the horizon in degrees, -90 to 90.</source>
        <translation>Высота луны над горизонтом в градусах, от -90 до 90.</translation>
    </message>
    <message>
        <source>Distance of the moon in kilometres, 100000 to 1000000. It sets the size and the brightness of the disc.</source>
        <translation>Расстояние до луны в километрах, от 100000 до 1000000. От него зависят размер и яркость диска.</translation>
    </message>
    <message>
        <source>The stars to magnitude 6 and the Milky Way. If the sun is given by date, time and place, what is left out here follows from them.</source>
        <translation>Звёзды до 6-й величины и Млечный Путь. Если солнце задано датой, временем и местом, то всё, что здесь не указано, следует из них.</translation>
    </message>
    <message>
        <source>Whether stars shine at night.</source>
        <translation>Светят ли ночью звёзды.</translation>
    </message>
    <message>
        <source>Latitude of the place in degrees, positive to the north, -90 to 90. The pole stands as high.</source>
        <translation>Широта места в градусах, к северу положительная, от -90 до 90. На такой высоте стоит полюс мира.</translation>
    </message>
    <message>
        <source>Local sidereal time in degrees, -360 to 360: the right ascension of the stars that stand due south.</source>
        <translation>Местное звёздное время в градусах, от -360 до 360: прямое восхождение звёзд, которые стоят точно на юге.</translation>
    </message>
    <message>
        <source>Year in whose frame the stars stand, 1900 to 2100 (precession).</source>
        <translation>Год, в системе координат которого стоят звёзды, от 1900 до 2100 (прецессия).</translation>
    </message>
    <message>
        <source>Brightness of the Milky Way relative to the real one, 0 to 10.</source>
        <translation>Яркость Млечного Пути относительно настоящего, от 0 до 10.</translation>
    </message>
    <message>
        <source>Angular diameter in degrees of the sun&apos;s disc, which makes the edges of shadows soft, 0.01 to 10. The irradiance does not depend on it.</source>
        <translation>Угловой диаметр солнечного диска в градусах, от 0,01 до 10: из-за него края теней мягкие. Облучённость от него не зависит.</translation>
    </message>
    <message>
        <source>Radiance of the sky in all directions, also below the horizon. If it is given, there are neither air, haze and fog nor clouds, and sunlight arrives as /sun/irradiance says. If it is left out, the sky follows from the air. Linear Rec. 709 [red, green, blue], each 0 to 1000000.</source>
        <translation>Яркость неба во всех направлениях, также ниже горизонта. Если она задана, нет ни воздуха, дымки и тумана, ни облаков, и свет солнца доходит таким, как задано в /sun/irradiance. Если её нет, небо следует из воздуха. Линейный Rec. 709 [красный, зелёный, синий], каждый от 0 до 1000000.</translation>
    </message>
    <message>
        <source>Phong coefficients of each material. Ground and sea have their colours from the biome unless surfaces is plain.</source>
        <translation>Коэффициенты Фонга для каждого материала. Цвета земли и моря задаёт биом, если surfaces не plain.</translation>
    </message>
    <message>
        <source>Look of all surfaces. full (the default) has textures, bumps, gloss, waves and translucent cloth. plain has none of them: each surface reflects light evenly in all directions (Lambert), and nothing shines. Its albedo is that of its material, multiplied by the colours of balloon, plants and stones. Such pictures can be compared with those of other renderers.</source>
        <translation>Вид всех поверхностей. full (по умолчанию): с текстурами, рельефом, бликами, волнами и просвечивающей тканью. plain: без всего этого; каждая поверхность отражает свет равномерно во все стороны (по Ламберту), и ничто не светится. Альбедо задаёт материал; у шара, растений и камней оно умножается на их цвета. Такие картины можно сравнивать с картинами других программ.</translation>
    </message>
    <message>
        <source>Factor on the colours of the object. For terrain and water, it is their colour if /surfaces is plain, and has no effect otherwise. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Множитель цветов объекта. Для земли и воды это их цвет, если /surfaces — plain; иначе он не действует. Линейный Rec. 709 [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>The ground: a square of cells x cells quads around center. The quads grow outwards. Defaults come with the biome, or from the elevation data of source.</source>
        <translation>Поверхность земли: квадрат из cells x cells ячеек вокруг center. Ячейки растут к краям. Значения по умолчанию задаёт биом или данные о высотах из source.</translation>
    </message>
    <message>
        <source>Overall shape of the ground. elevation is that of source and needs it; it is the default with a source.</source>
        <translation>Общая форма земли. elevation — это рельеф из source, и он обязателен; если source задан, это значение по умолчанию.</translation>
    </message>
    <message>
        <source>Files of elevation data, or folders of them, at most 4096, relative to the folder of the scene file. A single name needs no list. Where files overlap, the first wins.</source>
        <translation>Файлы с данными о высотах или папки с ними, не больше 4096, относительно папки файла сцены. Одно имя можно дать без списка. Где файлы перекрываются, действует первый.</translation>
    </message>
    <message>
        <source>Name of a file or of a folder.</source>
        <translation>Имя файла или папки.</translation>
    </message>
    <message>
        <source>Coordinate reference system of the source, such as EPSG:2056, which wins over what the files say.</source>
        <translation>Система координат данных, например EPSG:2056. Она важнее того, что говорят файлы.</translation>
    </message>
    <message>
        <source>Unit of the heights in the source. auto (the default) goes by what the files say, and takes metres if they say nothing. ft is the international foot, us-ft that of US surveys.</source>
        <translation>Единица высот в данных. auto (по умолчанию) следует файлам, а если они молчат, берёт метры. ft — международный фут, us-ft — фут геодезистов США.</translation>
    </message>
    <message>
        <source>Value of samples of the source that have no height, -1000000000 to 1000000000. Samples that are no numbers, or below -1e30, never have one.</source>
        <translation>Значение отсчётов без высоты, от -1000000000 до 1000000000. Отсчёты, которые не являются числами или меньше -1e30, высоты не имеют никогда.</translation>
    </message>
    <message>
        <source>Heights in metres of black and of white, for images and other sources that do not give them.</source>
        <translation>Высоты чёрного и белого в метрах для изображений и других данных, которые их не задают.</translation>
    </message>
    <message>
        <source>Distance of neighbouring samples in metres, 0 (excluded) to 1000000, for sources that do not say where they lie.</source>
        <translation>Расстояние между соседними отсчётами в метрах, от 0 (исключая) до 1000000, для данных, которые не говорят, где они лежат.</translation>
    </message>
    <message>
        <source>How the colours of image tiles hold heights. auto (the default) finds out.</source>
        <translation>Как цвета плиток хранят высоты. auto (по умолчанию) определяет это само.</translation>
    </message>
    <message>
        <source>Name of the variable that holds heights, for files with several.</source>
        <translation>Имя переменной с высотами, если их в файле несколько.</translation>
    </message>
    <message>
        <source>Layout of a file that holds nothing but samples, such as .r16 and .raw.</source>
        <translation>Устройство файла, в котором нет ничего, кроме отсчётов, например .r16 и .raw.</translation>
    </message>
    <message>
        <source>Samples in a row, 0 (a square file) to 1048576.</source>
        <translation>Отсчётов в строке, от 0 (квадратный файл) до 1048576.</translation>
    </message>
    <message>
        <source>Rows, 0 (a square file) to 1048576.</source>
        <translation>Строк, от 0 (квадратный файл) до 1048576.</translation>
    </message>
    <message>
        <source>Type of a sample. auto (the default) goes by the name of the file: uint16 for .r16 and .raw, float32 for .r32.</source>
        <translation>Тип отсчёта. auto (по умолчанию) следует имени файла: uint16 для .r16 и .raw, float32 для .r32.</translation>
    </message>
    <message>
        <source>Whether the first byte of a sample is its most significant one.</source>
        <translation>Старший ли байт отсчёта идёт первым.</translation>
    </message>
    <message>
        <source>Bytes before the first sample, 0 to 1000000000.</source>
        <translation>Байтов перед первым отсчётом, от 0 до 1000000000.</translation>
    </message>
    <message>
        <source>Point of the source that lies at center. It is a latitude and longitude, or an easting and northing in the source&apos;s own coordinates. If it is left out, the middle of the source counts.</source>
        <translation>Точка данных, которая лежит в center. Это широта и долгота или координаты на восток и на север в собственной системе данных. Если её нет, берётся середина данных.</translation>
    </message>
    <message>
        <source>Latitude in degrees, -90 to 90 (north).</source>
        <translation>Широта в градусах, от -90 до 90 (север).</translation>
    </message>
    <message>
        <source>Longitude in degrees, -360 to 360; east is positive.</source>
        <translation>Долгота в градусах, от -360 до 360; восточная положительна.</translation>
    </message>
    <message>
        <source>First coordinate, from west to east, in the units of the source, -1000000000 to 1000000000.</source>
        <translation>Первая координата, с запада на восток, в единицах данных, от -1000000000 до 1000000000.</translation>
    </message>
    <message>
        <source>Second coordinate, from south to north, in the units of the source, -1000000000 to 1000000000.</source>
        <translation>Вторая координата, с юга на север, в единицах данных, от -1000000000 до 1000000000.</translation>
    </message>
    <message>
        <source>Side of the square around place in metres, 10 to 1000000, from which the view is chosen. If it is left out, all of the source counts.</source>
        <translation>Сторона квадрата вокруг place в метрах, от 10 до 1000000, в котором выбирается вид. Если её нет, берутся все данные.</translation>
    </message>
    <message>
        <source>What lies where the source has no heights over a large area. land (the default) goes on like the land around it, and sea is water.</source>
        <translation>Что лежит там, где у данных на большой площади нет высот. land (по умолчанию) продолжает землю вокруг, а sea — это вода.</translation>
    </message>
    <message>
        <source>Whether the ground of a source falls away with the curvature of the Earth, less what refraction gives back.</source>
        <translation>Уходит ли земля вниз с кривизной Земли за вычетом рефракции.</translation>
    </message>
    <message>
        <source>Strength of the relief that is added where the mesh is finer than the source, 0 (the source alone) to 4.</source>
        <translation>Сила рельефа, который добавляется там, где сетка мельче данных, от 0 (только данные) до 4.</translation>
    </message>
    <message>
        <source>Place on the Earth. Only scenes on real land have such places.</source>
        <translation>Место на Земле. Такие места есть только у сцен на настоящей земле.</translation>
    </message>
    <message>
        <source>Height in metres, -100000 to 100000, above the level that height_above names.</source>
        <translation>Высота в метрах, от -100000 до 100000, над уровнем, который называет height_above.</translation>
    </message>
    <message>
        <source>Flight that a logger recorded. The balloon is where it was at a moment, and the sun as well, unless the scene gives another. It wins over position.</source>
        <translation>Полёт, записанный прибором. Шар и солнце находятся там, где были в этот момент, если сцена не задаёт другого солнца. Он важнее position.</translation>
    </message>
    <message>
        <source>Name of an IGC, GPX, KML or KMZ file, relative to the folder of the scene file.</source>
        <translation>Имя файла IGC, GPX, KML или KMZ относительно папки файла сцены.</translation>
    </message>
    <message>
        <source>Time of the flight, such as 2023-10-02T07:45:10Z. It wins over share.</source>
        <translation>Время полёта, например 2023-10-02T07:45:10Z. Оно важнее share.</translation>
    </message>
    <message>
        <source>Share of the flight&apos;s time, 0 (take-off) to 1 (landing). If neither it nor a time is given, it is 0.5.</source>
        <translation>Доля времени полёта, от 0 (взлёт) до 1 (посадка). Если нет ни её, ни времени, берётся 0.5.</translation>
    </message>
    <message>
        <source>Number of the track in the file, 0 (the longest) to 100000.</source>
        <translation>Номер трека в файле, от 0 (самый длинный) до 100000.</translation>
    </message>
    <message>
        <source>Time of the first fix, for tracks without times.</source>
        <translation>Время первой точки для треков без времени.</translation>
    </message>
    <message>
        <source>Seconds from fix to fix, 0 to 86400, for tracks without times.</source>
        <translation>Секунд от точки до точки, от 0 до 86400, для треков без времени.</translation>
    </message>
    <message>
        <source>Picture that lies over the ground of a source, such as an orthophoto. Where it is transparent and outside of it, the ground has its own colours.</source>
        <translation>Снимок поверх земли из данных, например ортофотоплан. Там, где он прозрачен, и за его краями у земли собственные цвета.</translation>
    </message>
    <message>
        <source>Name of the picture, relative to the folder of the scene file: GeoTIFF, PNG or JPEG. An empty name means that there is none.</source>
        <translation>Имя снимка относительно папки файла сцены: GeoTIFF, PNG или JPEG. Пустое имя означает, что снимка нет.</translation>
    </message>
    <message>
        <source>Share of the picture in the colour of the ground, 0 (the ground&apos;s own colours) to 1 (the picture alone).</source>
        <translation>Доля снимка в цвете земли, от 0 (собственные цвета земли) до 1 (только снимок).</translation>
    </message>
    <message>
        <source>Coordinate reference system of the picture, such as EPSG:3857, which wins over what the file says.</source>
        <translation>Система координат снимка, например EPSG:3857; она важнее того, что указано в файле.</translation>
    </message>
    <message>
        <source>Places of two corners of the picture, for one that does not say where it lies. Its rows run from west to east and its columns from north to south.</source>
        <translation>Места двух углов снимка, если в нём не указано, где он лежит. Его строки идут с запада на восток, а столбцы с севера на юг.</translation>
    </message>
    <message>
        <source>Outer corner of the first pixel of the first row, [latitude, longitude] in degrees on WGS 84.</source>
        <translation>Внешний угол первого пикселя первой строки, [широта, долгота] в градусах WGS 84.</translation>
    </message>
    <message>
        <source>Outer corner of the last pixel of the last row, [latitude, longitude] in degrees on WGS 84.</source>
        <translation>Внешний угол последнего пикселя последней строки, [широта, долгота] в градусах WGS 84.</translation>
    </message>
    <message>
        <source>What becomes of level areas of a source. auto (the default) makes lakes and rivers of them, and none leaves them dry.</source>
        <translation>Чем становятся ровные участки источника. auto (по умолчанию) делает из них озёра и реки, none оставляет их сухими.</translation>
    </message>
    <message>
        <source>Models from files that stand in the landscape, at most 1000. A file that is named more than once is read once.</source>
        <translation>Модели из файлов, которые стоят в ландшафте, не более 1000. Файл, названный несколько раз, читается один раз.</translation>
    </message>
    <message>
        <source>Model from a file that stands in the landscape.</source>
        <translation>Модель из файла, которая стоит в ландшафте.</translation>
    </message>
    <message>
        <source>Name of a glTF (.glb, .gltf), OBJ, PLY or STL file, relative to the folder of the scene file.</source>
        <translation>Имя файла glTF (.glb, .gltf), OBJ, PLY или STL относительно папки файла сцены.</translation>
    </message>
    <message>
        <source>Place of the foot, which is the lowest point of the model, in the middle of its bounding box, the origin by default. [x, y, z] in metres, y up.</source>
        <translation>Место основания: нижняя точка модели в середине её ограничивающего параллелепипеда, по умолчанию начало координат. [x, y, z] в метрах, ось y направлена вверх.</translation>
    </message>
    <message>
        <source>Level from which the y of the position is measured: the sea, or the ground below the model (the default).</source>
        <translation>Уровень, от которого отсчитывается y положения: море или земля под моделью (по умолчанию).</translation>
    </message>
    <message>
        <source>Rotation about the vertical axis in degrees, -360 to 360, clockwise as seen from above. At 0, the x of the file points to the east, and its z to the south.</source>
        <translation>Поворот вокруг вертикальной оси в градусах, от -360 до 360, по часовой стрелке при взгляде сверху. При 0 ось x файла направлена на восток, а ось z на юг.</translation>
    </message>
    <message>
        <source>Metres for each unit of the file, 0 to 1000000, 1 by default.</source>
        <translation>Метров в единице файла, от 0 до 1000000, по умолчанию 1.</translation>
    </message>
    <message>
        <source>Height of the model in metres, 0 to 10000. It wins over scale.</source>
        <translation>Высота модели в метрах, от 0 до 10000. Она важнее масштаба.</translation>
    </message>
    <message>
        <source>Axis of the file that points up. It is always y in glTF, which is the default, and often z in files from CAD programs.</source>
        <translation>Ось файла, направленная вверх. В glTF это всегда y (по умолчанию), а в файлах программ САПР часто z.</translation>
    </message>
    <message>
        <source>Line along the way of a flight. An empty object is enough.</source>
        <translation>Линия вдоль пути полёта. Достаточно пустого объекта.</translation>
    </message>
    <message>
        <source>Thickness of the line in metres, 0.01 to 1000.</source>
        <translation>Толщина линии в метрах, от 0.01 до 1000.</translation>
    </message>
    <message>
        <source>Albedo of the line in the air. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо линии в воздухе. Линейные Rec. 709 [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Whether there is another line on the ground below.</source>
        <translation>Есть ли ещё одна линия внизу на земле.</translation>
    </message>
    <message>
        <source>Albedo of the line on the ground. Linear Rec. 709 [red, green, blue], each 0 to 1.</source>
        <translation>Альбедо линии на земле. Линейные Rec. 709 [красный, зелёный, синий], каждый от 0 до 1.</translation>
    </message>
    <message>
        <source>Kind of landscape, which sets the defaults of terrain, colours, light, sky, air and balloons. auto is the same as leaving it out: on a source of elevation data the kind is chosen by latitude, height and season, and elsewhere it is snow.</source>
        <translation>Вид ландшафта, задающий значения по умолчанию для рельефа, цветов, света, неба, воздуха и шаров. auto означает то же, что и отсутствие значения: на данных высот вид выбирается по широте, высоте и времени года, а в остальных случаях это snow.</translation>
    </message>
    <message>
        <source>Raster of land cover, whose codes say what grows and lies on the ground of a source: ESA WorldCover, NLCD, CORINE and others. Where it ends, the biome&apos;s rules decide.</source>
        <translation>Растр земного покрова, коды которого говорят, что растёт и лежит на земле источника: ESA WorldCover, NLCD, CORINE и другие. За его пределами решают правила биома.</translation>
    </message>
    <message>
        <source>Name of the raster, relative to the folder of the scene file. An empty name means that there is none.</source>
        <translation>Имя растра относительно папки файла сцены. Пустое имя означает, что растра нет.</translation>
    </message>
    <message>
        <source>Meaning of the codes. auto (the default) goes by the codes that occur.</source>
        <translation>Значение кодов. auto (по умолчанию) определяет его по встречающимся кодам.</translation>
    </message>
    <message>
        <source>Coordinate reference system of the raster, such as EPSG:5070, which wins over what the file says.</source>
        <translation>Система координат растра, например EPSG:5070; она важнее указанной в файле.</translation>
    </message>
    <message>
        <source>Classes of further codes, at most 256, which win over those of the scheme.</source>
        <translation>Классы дополнительных кодов, не более 256; они важнее классов схемы.</translation>
    </message>
    <message>
        <source>Class of a code of land cover.</source>
        <translation>Класс кода земного покрова.</translation>
    </message>
    <message>
        <source>Code, -32768 to 65535.</source>
        <translation>Код, от -32768 до 65535.</translation>
    </message>
    <message>
        <source>What the code stands for.</source>
        <translation>Что означает код.</translation>
    </message>
    <message>
        <source>Time in seconds at which the waves are seen, 0 to 1000000. A film lets it pass.</source>
        <translation>Время в секундах, в которое видны волны, от 0 до 1000000. В фильме оно идёт.</translation>
    </message>
    <message>
        <source>How far the wind has carried the thin, high clouds across the sky over the camera, [x, z] in metres, each -1000000 to 1000000. A film moves it by its wind, and against its camera.</source>
        <translation>Насколько ветер отнёс тонкие высокие облака по небу над камерой, [x, z] в метрах, каждое число от -1000000 до 1000000. В фильме их двигает ветер, а движение камеры возмещается.</translation>
    </message>
    <message>
        <source>How far the wind has carried the clouds, [x, z] in metres, each -1000000 to 1000000. A film moves it by its wind.</source>
        <translation>Насколько ветер отнёс облака, [x, z] в метрах, каждое число от -1000000 до 1000000. В фильме их двигает ветер.</translation>
    </message>
    <message>
        <source>The film of the scene, which aerostat film makes.</source>
        <translation>Фильм о сцене, который делает aerostat film.</translation>
    </message>
    <message>
        <source>Length of the film in seconds, above 0 to 86400.</source>
        <translation>Длительность фильма в секундах, больше 0 и до 86400.</translation>
    </message>
    <message>
        <source>Frames per second, above 0 to 240.</source>
        <translation>Кадров в секунду, больше 0 и до 240.</translation>
    </message>
    <message>
        <source>Values that move, at most 64 of them.</source>
        <translation>Значения, которые меняются, не больше 64.</translation>
    </message>
    <message>
        <source>The keys of one value. Before the first key and after the last one, the value stays as they have it.</source>
        <translation>Ключи одного значения. До первого ключа и после последнего значение остаётся таким, как в них.</translation>
    </message>
    <message>
        <source>JSON pointer of the value that moves, such as /sun/elevation_deg: a number, an array of numbers, a word, or /sun/time. Angles that go full circle take the shorter way.</source>
        <translation>Указатель JSON на значение, которое меняется, например /sun/elevation_deg: число, массив чисел, слово или /sun/time. Углы полного круга идут более коротким путём.</translation>
    </message>
    <message>
        <source>How the value goes from one key to the next: linear at an even rate, smooth (the default) slowly at both ends, and hold not at all until the next key. Words always hold.</source>
        <translation>Как значение переходит от ключа к ключу: linear — равномерно, smooth (по умолчанию) — медленно на обоих концах, hold — не меняется до следующего ключа. Слова всегда держатся до следующего ключа.</translation>
    </message>
    <message>
        <source>Keys with rising times, at most 1000.</source>
        <translation>Ключи с возрастающими временами, не больше 1000.</translation>
    </message>
    <message>
        <source>A key: the value at a time.</source>
        <translation>Ключ: значение в некоторое время.</translation>
    </message>
    <message>
        <source>Time from the beginning of the film in seconds, 0 to 86400.</source>
        <translation>Время от начала фильма в секундах, от 0 до 86400.</translation>
    </message>
    <message>
        <source>The value at that time, in the form that the scene has it.</source>
        <translation>Значение в это время в том виде, в каком оно стоит в сцене.</translation>
    </message>
    <message>
        <source>Profile of the wind: layers with rising heights, at most 32. It carries balloons and clouds along. By default, it blows from the west at 3 m/s. Without any layer, balloons and clouds stand still.</source>
        <translation>Профиль ветра: слои с возрастающими высотами, не больше 32. Ветер несёт шары и облака. По умолчанию он дует с запада со скоростью 3 м/с. Без слоёв шары и облака стоят на месте.</translation>
    </message>
    <message>
        <source>The wind at a height.</source>
        <translation>Ветер на некоторой высоте.</translation>
    </message>
    <message>
        <source>Height above the sea in metres, -1000 to 100000.</source>
        <translation>Высота над морем в метрах, от -1000 до 100000.</translation>
    </message>
    <message>
        <source>Speed of the air in metres per second, 0 to 200.</source>
        <translation>Скорость воздуха в метрах в секунду, от 0 до 200.</translation>
    </message>
    <message>
        <source>Azimuth from which the wind comes in degrees, -360 to 360: 270 is a west wind, which blows to the east.</source>
        <translation>Азимут, откуда дует ветер, в градусах, от -360 до 360: 270 — западный ветер, он дует на восток.</translation>
    </message>
    <message>
        <source>Slow turn of balloons in the wind in degrees per second, -360 to 360.</source>
        <translation>Медленный поворот шаров на ветру в градусах в секунду, от -360 до 360.</translation>
    </message>
    <message>
        <source>How many seconds of the recorded flight of /balloon/track pass in a second of the film, 0 to 100000. The film begins at the moment of the flight that the track names by at or share, or else at its take-off.</source>
        <translation>Сколько секунд записанного полёта /balloon/track проходит за секунду фильма, от 0 до 100000. Фильм начинается в тот момент полёта, который указан в at или share, а без них — со взлёта.</translation>
    </message>
    <message>
        <source>Seconds between the moments at which the light is metered, above 0 to 86400. The exposure goes evenly from one to the next, so that it never flickers. It does not matter if /image/exposure_ev is given.</source>
        <translation>Секунды между моментами, в которые измеряется свет, больше 0 и до 86400. Между ними экспозиция меняется равномерно и поэтому не мерцает. Если задано /image/exposure_ev, это значение не действует.</translation>
    </message>
    <message>
        <source>How the camera moves.</source>
        <translation>Как движется камера.</translation>
    </message>
    <message>
        <source>scene (the default) leaves the camera where the scene and its keys put it. path flies through the points of path. orbit circles the balloon. chase follows the balloon from where the scene has the camera, softly. basket looks from the basket. ground stands on the ground below the scene&apos;s camera.</source>
        <translation>scene (по умолчанию): камера остаётся там, куда её ставят сцена и ключи. path: летит через точки path. orbit: кружит вокруг шара. chase: мягко следует за шаром с того места, где она стоит в сцене. basket: смотрит из корзины. ground: стоит на земле под камерой сцены.</translation>
    </message>
    <message>
        <source>What the camera looks at: target is the scene&apos;s own, balloon the middle of the balloon, ahead where the camera goes. usual (the default) is the balloon with orbit, chase and ground, ahead with basket, and target with scene and path.</source>
        <translation>Куда смотрит камера: target — цель камеры сцены, balloon — середина шара, ahead — туда, куда движется камера. usual (по умолчанию) — balloon для orbit, chase и ground, ahead для basket, target для scene и path.</translation>
    </message>
    <message>
        <source>Points of a path, at most 1000; a smooth curve leads through them.</source>
        <translation>Точки пути, не больше 1000; через них проходит плавная кривая.</translation>
    </message>
    <message>
        <source>A point of the camera&apos;s path.</source>
        <translation>Точка пути камеры.</translation>
    </message>
    <message>
        <source>Position of the camera. Its height counts from the level that /camera/height_above names, as it is there when the film begins. [x, y, z] in metres, y up.</source>
        <translation>Положение камеры. Высота отсчитывается от уровня, названного в /camera/height_above, каким он там в начале фильма. [x, y, z] в метрах, y вверх.</translation>
    </message>
    <message>
        <source>Time in seconds at which the camera is there, 0 to 86400. If no point has one, the points share the film&apos;s time evenly.</source>
        <translation>Время в секундах, в которое камера находится там, от 0 до 86400. Если ни у одной точки его нет, точки делят время фильма поровну.</translation>
    </message>
    <message>
        <source>Whether the camera flies along its path at an even speed, from the first time to the last. The times of the points between do not matter then.</source>
        <translation>Летит ли камера по пути с постоянной скоростью, от первого времени до последнего. Времена точек между ними тогда не действуют.</translation>
    </message>
    <message>
        <source>Distance of an orbit from the balloon&apos;s axis in metres, 0.1 to 100000.</source>
        <translation>Расстояние облёта от оси шара в метрах, от 0.1 до 100000.</translation>
    </message>
    <message>
        <source>Height of an orbit above the floor of the basket in metres, -10000 to 100000.</source>
        <translation>Высота облёта над полом корзины в метрах, от -10000 до 100000.</translation>
    </message>
    <message>
        <source>Azimuth in degrees, seen from the balloon, at which an orbit begins, -360 to 360.</source>
        <translation>Азимут в градусах, считая от шара, с которого начинается облёт, от -360 до 360.</translation>
    </message>
    <message>
        <source>Turn of an orbit in degrees per second, -360 to 360. Positive turns go from north to east.</source>
        <translation>Поворот облёта в градусах в секунду, от -360 до 360. Положительный поворот идёт с севера на восток.</translation>
    </message>
    <message>
        <source>Time in seconds by which a chase lags behind the balloon, 0 to 60.</source>
        <translation>Время в секундах, на которое камера отстаёт от шара, от 0 до 60.</translation>
    </message>
    <message>
        <source>By how much the light and shade of the sun that shone when the picture was taken are taken out of it, 0 (not at all, the default) to 1. The sun is found from the shape of the land.</source>
        <translation>Насколько из снимка убраны свет и тени солнца, светившего во время съёмки: от 0 (совсем нет, по умолчанию) до 1. Положение солнца находится по форме земли.</translation>
    </message>
    <message>
        <source>Position of the light. Each light needs either this or a place on the Earth. [x, y, z] in metres, y up.</source>
        <translation>Положение источника света. Каждому источнику нужно либо оно, либо место на Земле. [x, y, z] в метрах, y направлена вверх.</translation>
    </message>
    <message>
        <source>Level from which the y of the position is measured: the sea (the default), or the ground below the light. The height of a place on the Earth is measured from the ground by default.</source>
        <translation>Уровень, от которого отсчитывается y положения: море (по умолчанию) или земля под источником света. Высота места на Земле по умолчанию отсчитывается от земли.</translation>
    </message>
    <message>
        <source>Number of instances, 1 to 1000000. More than one are strewn over the area. There are at most 1000000 instances in all.</source>
        <translation>Число экземпляров, от 1 до 1000000. Если их больше одного, они рассеяны по участку. Всего экземпляров не больше 1000000.</translation>
    </message>
    <message>
        <source>Area over which the instances of a model are strewn, and the rules by which they stand. The position of the model is the middle of the area. Where the rules leave no room, there are fewer instances.</source>
        <translation>Участок, по которому рассеяны экземпляры модели, и правила, по которым они стоят. Положение модели — середина участка. Где правила не оставляют места, экземпляров меньше.</translation>
    </message>
    <message>
        <source>Width of the area along x and along z in metres.</source>
        <translation>Ширина участка вдоль x и вдоль z в метрах.</translation>
    </message>
    <message>
        <source>Seed of places, sizes and headings, 0 to 4294967295.</source>
        <translation>Зерно мест, размеров и направлений, от 0 до 4294967295.</translation>
    </message>
    <message>
        <source>Where instances stand: on land (the default), on water, where they float at its level, or anywhere on the ground, wet or dry.</source>
        <translation>Где стоят экземпляры: land — на суше (по умолчанию), water — на воде, где они плавают на её уровне, anywhere — где угодно на земле, под водой или нет.</translation>
    </message>
    <message>
        <source>Least and greatest slope of the ground in degrees, each 0 to 90.</source>
        <translation>Наименьший и наибольший уклон земли в градусах, каждый от 0 до 90.</translation>
    </message>
    <message>
        <source>Least and greatest height of the ground above the sea in metres.</source>
        <translation>Наименьшая и наибольшая высота земли над морем в метрах.</translation>
    </message>
    <message>
        <source>Least distance from the middle of an instance to those of all other models in metres, 0 to 10000.</source>
        <translation>Наименьшее расстояние от середины экземпляра до середин всех других моделей в метрах, от 0 до 10000.</translation>
    </message>
    <message>
        <source>Least and greatest factor on the size of the model, each 0.001 to 1000.</source>
        <translation>Наименьший и наибольший множитель размера модели, каждый от 0.001 до 1000.</translation>
    </message>
    <message>
        <source>Whether each instance has a heading of its own (the default). Otherwise, all have that of the model.</source>
        <translation>Есть ли у каждого экземпляра своё направление (по умолчанию). Иначе у всех направление модели.</translation>
    </message>
    <message>
        <source>Number of people in the basket, 0 (nobody, the default) to 3.</source>
        <translation>Число людей в корзине, от 0 (никого, по умолчанию) до 3.</translation>
    </message>
    <message>
        <source>Pictures on the envelope, at most 16. Later ones lie over former ones.</source>
        <translation>Рисунки на оболочке, не больше 16. Более поздние лежат поверх более ранних.</translation>
    </message>
    <message>
        <source>Picture on the envelope. Heights count along the cloth from the mouth. Where the picture is transparent, the colours of the fabric show.</source>
        <translation>Рисунок на оболочке. Высоты отсчитываются вдоль ткани от горловины. Где рисунок прозрачен, видны цвета ткани.</translation>
    </message>
    <message>
        <source>Name of a PNG, JPEG or SVG file, relative to the folder of the scene file.</source>
        <translation>Имя файла PNG, JPEG или SVG относительно папки файла сцены.</translation>
    </message>
    <message>
        <source>How the picture lies on the cloth: whole (the default) is stretched once around and from the mouth to the crown, band goes around between two heights, motif lies at a place in its own proportions, and gores was drawn on the template that the command artwork writes.</source>
        <translation>Как рисунок лежит на ткани: whole (по умолчанию) растянут один раз вокруг и от горловины до вершины, band идёт вокруг между двумя высотами, motif лежит на одном месте со своими пропорциями, а gores нарисован на шаблоне, который пишет команда artwork.</translation>
    </message>
    <message>
        <source>Direction in which the middle of the picture lies, in degrees from the heading of the balloon, -360 to 360, clockwise as seen from above. It does not turn a picture on the template.</source>
        <translation>Направление, в котором лежит середина рисунка, в градусах от курса шара, от -360 до 360, по часовой стрелке при взгляде сверху. Рисунок на шаблоне оно не поворачивает.</translation>
    </message>
    <message>
        <source>Height of the middle of a motif along the cloth in metres, 0 to 1000, that of the widest place by default.</source>
        <translation>Высота середины мотива вдоль ткани в метрах, от 0 до 1000, по умолчанию самого широкого места.</translation>
    </message>
    <message>
        <source>Width of a motif in metres, 0 to 1000, 0.4 diameters by default.</source>
        <translation>Ширина мотива в метрах, от 0 до 1000, по умолчанию 0.4 диаметра.</translation>
    </message>
    <message>
        <source>Heights of the lower and of the upper edge of a band along the cloth in metres, each 0 to 1000. By default, the band is a fifth of the cloth high, with the widest place in its middle.</source>
        <translation>Высоты нижнего и верхнего края полосы вдоль ткани в метрах, каждая от 0 до 1000. По умолчанию полоса высотой в пятую часть ткани, с самым широким местом посередине.</translation>
    </message>
    <message>
        <source>Number of copies around the envelope, 1 to 256. By default it is 1, but for a band, whose copies keep their proportions as nearly as they close.</source>
        <translation>Число копий вокруг оболочки, от 1 до 256. По умолчанию 1, но у полосы копий столько, чтобы они смыкались и как можно точнее сохраняли пропорции.</translation>
    </message>
    <message>
        <source>Envelope of a special shape: the surface of a model from a file is its cloth, in the colours of the model. Skirt, cables and basket hang below its lowest point, which is in the middle of its bounding box. It has no artwork.</source>
        <translation>Оболочка особой формы: её ткань — поверхность модели из файла, в цветах модели. Юбка, тросы и корзина висят под её самой низкой точкой, посередине описанного ящика. Рисунков на ней нет.</translation>
    </message>
    <message>
        <source>Axis of the file that points up, y by default.</source>
        <translation>Ось файла, направленная вверх, по умолчанию y.</translation>
    </message>
    <message>
        <source>Height of the envelope in metres, 0 to 200, by default that of the usual envelope of the balloon&apos;s diameter.</source>
        <translation>Высота оболочки в метрах, от 0 до 200, по умолчанию высота обычной оболочки с диаметром шара.</translation>
    </message>
    <message>
        <source>Rotation against the balloon in degrees, -360 to 360, clockwise as seen from above. At 0, the z of the file points backwards.</source>
        <translation>Поворот относительно шара в градусах, от -360 до 360, по часовой стрелке при взгляде сверху. При 0 ось z файла направлена назад.</translation>
    </message>
    <message>
        <source>Circles in which nothing grows, at most 4096. A film adds those that its camera and its balloons fly through, so that no plant vanishes before them.</source>
        <translation>Круги, в которых ничего не растёт, не больше 4096. Фильм добавляет круги на путях камеры и шаров, чтобы растения не исчезали перед ними.</translation>
    </message>
    <message>
        <source>A circle in which nothing grows.</source>
        <translation>Круг, в котором ничего не растёт.</translation>
    </message>
    <message>
        <source>Middle of the circle, [x, z] in metres, each -1000000 to 1000000.</source>
        <translation>Середина круга, [x, z] в метрах, каждое число от -1000000 до 1000000.</translation>
    </message>
    <message>
        <source>Radius of the circle in metres, 0 to 100000.</source>
        <translation>Радиус круга в метрах, от 0 до 100000.</translation>
    </message>
    <message>
        <source>How far the pattern that bends the streaks of the thin, high clouds has gone ahead of them in metres, -1000000 to 1000000, which changes their shape. A film moves it.</source>
        <translation>Насколько узор, который изгибает полосы тонких высоких облаков, ушёл вперёд них, в метрах, от -1000000 до 1000000; от этого меняется их форма. Его двигает фильм.</translation>
    </message>
    <message>
        <source>How far the bulges of the clouds have risen through them in metres, -1000000 to 1000000, which changes their shape. A film moves it.</source>
        <translation>Насколько клубы облаков поднялись сквозь них, в метрах, от -1000000 до 1000000; от этого меняется их форма. Их двигает фильм.</translation>
    </message>
    <message>
        <source>How fast clouds change their shape: the speed in metres per second at which bulges rise through heaped clouds, 0 to 1000. The pattern that bends the streaks of thin, high cloud moves ten times as fast. Films that show hours in seconds want 50 or more. 0 keeps the shapes.</source>
        <translation>Как быстро облака меняют форму: скорость в метрах в секунду, с которой клубы поднимаются сквозь кучевые облака, от 0 до 1000. Узор, который изгибает полосы тонких высоких облаков, движется в десять раз быстрее. Фильмам, которые показывают часы за секунды, нужно 50 или больше. 0 сохраняет форму.</translation>
    </message>
    <message>
        <source>Seconds from the beginning of the film within which the balloons of the festival take off, 0 to 86400. Each has its own time, which follows from the festival&apos;s seed, and stands on the ground until then; so their places are apart on the ground. If it is 0, all fly from the beginning.</source>
        <translation>Секунды от начала фильма, за которые взлетают шары фестиваля, от 0 до 86400. У каждого своё время, которое следует из зерна фестиваля, а до него шар стоит на земле; поэтому места на земле отстоят друг от друга. При 0 все летят с самого начала.</translation>
    </message>
    <message>
        <source>Speed in metres per second at which the balloons of the festival climb after take-off, above 0 to 50. They slow down towards their height.</source>
        <translation>Скорость в метрах в секунду, с которой шары фестиваля поднимаются после взлёта, больше 0 и до 50. К своей высоте они замедляются.</translation>
    </message>
    <message>
        <source>How long the shutter is open in each frame, in degrees of the frame&apos;s time, 0 to 360: what moves is blurred along its way. 180, half of the time, is what cinema cameras have. 0 (the default) shows one moment, which is the fastest. The shutter opens at the time of the frame.</source>
        <translation>Сколько открыт затвор в каждом кадре, в градусах времени кадра, от 0 до 360: то, что движется, размывается вдоль пути. 180, половина времени, как у кинокамер. 0 (по умолчанию) показывает одно мгновение и быстрее всего. Затвор открывается в момент кадра.</translation>
    </message>
    <message>
        <source>How many moments a frame with an open shutter averages, 2 to 64. They share the samples of a pixel, of which there are at least as many. What moves by more pixels within the shutter shows steps.</source>
        <translation>Сколько мгновений усредняет кадр с открытым затвором, от 2 до 64. Они делят между собой пробы пикселя, которых не меньше. На том, что сдвигается за это время на большее число пикселей, видны ступени.</translation>
    </message>
    <message>
        <source>Whether the usual plants of the biome grow. Without them, stones and the species from files remain.</source>
        <translation>Растут ли обычные растения биома. Без них остаются камни и виды из файлов.</translation>
    </message>
    <message>
        <source>Species of plants from files, at most 16, which grow beside the usual ones or in their place.</source>
        <translation>Виды растений из файлов, не больше 16, которые растут рядом с обычными или вместо них.</translation>
    </message>
    <message>
        <source>Species of plants whose shape is a model from a file. Its foot is the lowest point, in the middle of its bounding box.</source>
        <translation>Вид растений, форма которых — модель из файла. Её основание — нижняя точка посередине ограничивающего параллелепипеда.</translation>
    </message>
    <message>
        <source>Where the plants grow: in the woods (the default) in place of some of their trees, in the open outside of the woods, or anywhere on dry land.</source>
        <translation>Где растут растения: в лесу (по умолчанию) вместо части его деревьев, на открытых местах вне леса или повсюду на суше.</translation>
    </message>
    <message>
        <source>Least and greatest height of the plants in metres, each 0 to 1000. By default, all are as high as the model in the file. The size of /vegetation multiplies it.</source>
        <translation>Наименьшая и наибольшая высота растений в метрах, каждая от 0 до 1000. По умолчанию все они такой же высоты, как модель в файле. Размер из /vegetation умножает её.</translation>
    </message>
    <message>
        <source>Share of the trees of the woods that are of this species, 0 to 1. If the shares of all species together exceed 1, or if the biome&apos;s own do not grow, they count in proportion.</source>
        <translation>Доля деревьев леса, относящихся к этому виду, от 0 до 1. Если доли всех видов вместе превышают 1 или если растения самого биома не растут, они считаются пропорционально.</translation>
    </message>
    <message>
        <source>Number of plants on a hectare, 0 to 10000, if they do not grow in the woods. The density of /vegetation multiplies it.</source>
        <translation>Число растений на гектаре, от 0 до 10000, если они растут не в лесу. Густота из /vegetation умножает его.</translation>
    </message>
    <message>
        <source>Classes of land cover on which the plants grow, at most 9. By default, they grow on any. Where the scene has no land cover, plants with this rule do not grow.</source>
        <translation>Классы земного покрова, на которых растут растения, не больше 9. По умолчанию они растут на любом. Где в сцене нет земного покрова, растения с этим правилом не растут.</translation>
    </message>
    <message>
        <source>Share by which the brightness of the plants differs from that of the file at most, 0 to 1.</source>
        <translation>Доля, на которую яркость растений самое большее отличается от яркости в файле, от 0 до 1.</translation>
    </message>
    <message>
        <source>Classes of land cover on which instances stand, at most 9. By default, they stand on any. Where the scene has no land cover, the rule leaves no room.</source>
        <translation>Классы земного покрова, на которых стоят экземпляры, не больше 9. По умолчанию они стоят на любом. Где в сцене нет земного покрова, это правило не оставляет места.</translation>
    </message>
    <message>
        <source>Azimuth in degrees towards which the wind blows, -360 to 360. On land of any kind, ripples of sand and drifts of snow follow it.</source>
        <translation>Азимут в градусах, куда дует ветер, от -360 до 360. Вдоль него на любой местности тянутся рябь песка и снежные наносы.</translation>
    </message>
</context>
<context>
    <name>Units</name>
    <message>
        <source>m</source>
        <translation>м</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>px</source>
        <translation>пкс</translation>
    </message>
    <message>
        <source>EV</source>
        <translation>EV</translation>
    </message>
    <message>
        <source>K</source>
        <translation>К</translation>
    </message>
    <message>
        <source>DU</source>
        <translation>ед. Д.</translation>
    </message>
    <message>
        <source>km</source>
        <translation>км</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>snow</source>
        <translation>снег</translation>
    </message>
    <message>
        <source>tropical</source>
        <translation>тропики</translation>
    </message>
    <message>
        <source>sand</source>
        <translation>пески</translation>
    </message>
    <message>
        <source>sea</source>
        <translation>от моря</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>от земли</translation>
    </message>
    <message>
        <source>balloon</source>
        <translation>от корзины шара</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>плоское</translation>
    </message>
    <message>
        <source>gouraud</source>
        <translation>по Гуро</translation>
    </message>
    <message>
        <source>phong</source>
        <translation>по Фонгу</translation>
    </message>
    <message>
        <source>draft</source>
        <translation>черновик</translation>
    </message>
    <message>
        <source>standard</source>
        <translation>обычное</translation>
    </message>
    <message>
        <source>final</source>
        <translation>чистовое</translation>
    </message>
    <message>
        <source>stripes</source>
        <translation>полосы</translation>
    </message>
    <message>
        <source>chevrons</source>
        <translation>шевроны</translation>
    </message>
    <message>
        <source>spiral</source>
        <translation>спираль</translation>
    </message>
    <message>
        <source>rainbow</source>
        <translation>радуга</translation>
    </message>
    <message>
        <source>checker</source>
        <translation>шахматный</translation>
    </message>
    <message>
        <source>box</source>
        <translation>прямоугольный</translation>
    </message>
    <message>
        <source>tent</source>
        <translation>треугольный</translation>
    </message>
    <message>
        <source>gaussian</source>
        <translation>гауссов</translation>
    </message>
    <message>
        <source>pinhole</source>
        <translation>точечный</translation>
    </message>
    <message>
        <source>thin_lens</source>
        <translation>тонкая линза</translation>
    </message>
    <message>
        <source>panorama</source>
        <translation>панорама</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>параллельная проекция</translation>
    </message>
    <message>
        <source>ember</source>
        <translation>угли</translation>
    </message>
    <message>
        <source>lagoon</source>
        <translation>лагуна</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>спектр</translation>
    </message>
    <message>
        <source>glacier</source>
        <translation>ледник</translation>
    </message>
    <message>
        <source>orchard</source>
        <translation>сад</translation>
    </message>
    <message>
        <source>plum</source>
        <translation>слива</translation>
    </message>
    <message>
        <source>regatta</source>
        <translation>регата</translation>
    </message>
    <message>
        <source>meadow</source>
        <translation>луг</translation>
    </message>
    <message>
        <source>mountains</source>
        <translation>горы</translation>
    </message>
    <message>
        <source>island</source>
        <translation>остров</translation>
    </message>
    <message>
        <source>dunes</source>
        <translation>дюны</translation>
    </message>
    <message>
        <source>fbm</source>
        <translation>плавный</translation>
    </message>
    <message>
        <source>ridged</source>
        <translation>гребнистый</translation>
    </message>
    <message>
        <source>terrain</source>
        <translation>земля</translation>
    </message>
    <message>
        <source>water</source>
        <translation>вода</translation>
    </message>
    <message>
        <source>envelope</source>
        <translation>оболочка</translation>
    </message>
    <message>
        <source>skirt</source>
        <translation>юбка</translation>
    </message>
    <message>
        <source>basket</source>
        <translation>корзина</translation>
    </message>
    <message>
        <source>rim</source>
        <translation>борт</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>рама</translation>
    </message>
    <message>
        <source>cables</source>
        <translation>тросы</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>пол</translation>
    </message>
    <message>
        <source>flame</source>
        <translation>пламя</translation>
    </message>
    <message>
        <source>plant</source>
        <translation>растения</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>камни</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>снаружи</translation>
    </message>
    <message>
        <source>local</source>
        <translation>локально</translation>
    </message>
    <message>
        <source>path</source>
        <translation>по путям</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>весна</translation>
    </message>
    <message>
        <source>summer</source>
        <translation>лето</translation>
    </message>
    <message>
        <source>autumn</source>
        <translation>осень</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нет</translation>
    </message>
    <message>
        <source>dawn</source>
        <translation>рассвет</translation>
    </message>
    <message>
        <source>noon</source>
        <translation>полдень</translation>
    </message>
    <message>
        <source>golden</source>
        <translation>золотой час</translation>
    </message>
    <message>
        <source>dusk</source>
        <translation>сумерки</translation>
    </message>
    <message>
        <source>night</source>
        <translation>ночь</translation>
    </message>
    <message>
        <source>storm</source>
        <translation>гроза</translation>
    </message>
    <message>
        <source>mist</source>
        <translation>туман</translation>
    </message>
    <message>
        <source>full</source>
        <translation>полный</translation>
    </message>
    <message>
        <source>plain</source>
        <translation>простой</translation>
    </message>
    <message>
        <source>elevation</source>
        <translation>данные о высотах</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>авто</translation>
    </message>
    <message>
        <source>m</source>
        <translation>м</translation>
    </message>
    <message>
        <source>dm</source>
        <translation>дм</translation>
    </message>
    <message>
        <source>cm</source>
        <translation>см</translation>
    </message>
    <message>
        <source>ft</source>
        <translation>футы</translation>
    </message>
    <message>
        <source>us-ft</source>
        <translation>футы США</translation>
    </message>
    <message>
        <source>terrarium</source>
        <translation>terrarium</translation>
    </message>
    <message>
        <source>terrain-rgb</source>
        <translation>terrain-rgb</translation>
    </message>
    <message>
        <source>uint8</source>
        <translation>uint8</translation>
    </message>
    <message>
        <source>int8</source>
        <translation>int8</translation>
    </message>
    <message>
        <source>uint16</source>
        <translation>uint16</translation>
    </message>
    <message>
        <source>int16</source>
        <translation>int16</translation>
    </message>
    <message>
        <source>uint32</source>
        <translation>uint32</translation>
    </message>
    <message>
        <source>int32</source>
        <translation>int32</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>land</source>
        <translation>земля</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>track</source>
        <translation>линия полёта</translation>
    </message>
    <message>
        <source>worldcover</source>
        <translation>WorldCover</translation>
    </message>
    <message>
        <source>nlcd</source>
        <translation>NLCD</translation>
    </message>
    <message>
        <source>corine</source>
        <translation>CORINE</translation>
    </message>
    <message>
        <source>woods</source>
        <translation>лес</translation>
    </message>
    <message>
        <source>shrub</source>
        <translation>кустарник</translation>
    </message>
    <message>
        <source>crops</source>
        <translation>поля</translation>
    </message>
    <message>
        <source>bare</source>
        <translation>голая земля</translation>
    </message>
    <message>
        <source>built_up</source>
        <translation>застройка</translation>
    </message>
    <message>
        <source>wetland</source>
        <translation>болото</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>равномерно</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>плавно</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>держать</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>сцена</translation>
    </message>
    <message>
        <source>orbit</source>
        <translation>облёт</translation>
    </message>
    <message>
        <source>chase</source>
        <translation>погоня</translation>
    </message>
    <message>
        <source>usual</source>
        <translation>обычно</translation>
    </message>
    <message>
        <source>target</source>
        <translation>цель</translation>
    </message>
    <message>
        <source>ahead</source>
        <translation>вперёд</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>где угодно</translation>
    </message>
    <message>
        <source>whole</source>
        <translation>целиком</translation>
    </message>
    <message>
        <source>band</source>
        <translation>полоса</translation>
    </message>
    <message>
        <source>motif</source>
        <translation>мотив</translation>
    </message>
    <message>
        <source>gores</source>
        <translation>клинья</translation>
    </message>
    <message>
        <source>passenger</source>
        <translation>пассажир</translation>
    </message>
    <message>
        <source>open</source>
        <translation>открытые места</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::CameraControl</name>
    <message>
        <source>Free View</source>
        <translation>Свободный вид</translation>
    </message>
    <message>
        <source>View from the Basket</source>
        <translation>Вид из корзины</translation>
    </message>
    <message>
        <source>View from Outside</source>
        <translation>Вид снаружи</translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation>Облёт</translation>
    </message>
    <message>
        <source>Look Around</source>
        <translation>Поворот камеры</translation>
    </message>
    <message>
        <source>Move Closer or Away</source>
        <translation>Приближение или удаление</translation>
    </message>
    <message>
        <source>Fly</source>
        <translation>Полёт</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Наведение</translation>
    </message>
    <message>
        <source>Put the Balloon</source>
        <translation>Перенос шара</translation>
    </message>
    <message>
        <source>Camera: %1</source>
        <translation>Камера: %1</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ColorEditor</name>
    <message>
        <source>One more colour</source>
        <translation>Ещё один цвет</translation>
    </message>
    <message>
        <source>Remove the last colour</source>
        <translation>На один цвет меньше</translation>
    </message>
    <message>
        <source>Colour %1: %2</source>
        <translation>Цвет %1: %2</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ControlRow</name>
    <message>
        <source>Dice</source>
        <translation>Жребий</translation>
    </message>
    <message>
        <source>Another land</source>
        <translation>Другая земля</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>The seed before the dice was thrown</source>
        <translation>Номер до жребия</translation>
    </message>
    <message>
        <source>Reset to the Default</source>
        <translation>Вернуть значение по умолчанию</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Изменение: %1</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>Сброс: %1</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::Document</name>
    <message>
        <source>%1 Further faults: %2</source>
        <translation>%1 Других ошибок: %2</translation>
    </message>
    <message>
        <source>Out of memory</source>
        <translation>Не хватает памяти</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 и ещё %n</numerusform>
            <numerusform>%1 и ещё %n</numerusform>
            <numerusform>%1 и ещё %n</numerusform>
        </translation>
    </message>
    <message>
        <source>Saved. The scene names files outside of its folder: %1. This window opens it, but aerostat render needs --allow-external-paths. Without that, copy them beside the scene and name the copies.</source>
        <translation>Сохранено. Сцена называет файлы вне своей папки: %1. Это окно откроет её, но для aerostat render нужен ключ --allow-external-paths. Чтобы обойтись без него, скопируйте файлы к сцене и назовите копии.</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ExportDialog</name>
    <message>
        <source> px</source>
        <translation> пкс</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>Экспорт картины</translation>
    </message>
    <message>
        <source>A name that ends in .exr keeps the light as it is, with distances, normals and objects in layers; any other gives a PNG.</source>
        <translation>Файл .exr хранит свет как есть, а в слоях — расстояния, нормали и номера предметов; при любом другом имени получится PNG.</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Картинки (*.png)</translation>
    </message>
    <message>
        <source>OpenEXR (*.exr)</source>
        <translation>OpenEXR (*.exr)</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Записан файл %1</translation>
    </message>
    <message>
        <source>Cancelled</source>
        <translation>Отменено</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Размер: %1</translation>
    </message>
    <message>
        <source>This is the scene file itself; give the picture another name.</source>
        <translation>Это сам файл сцены; дайте снимку другое имя.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Файл изменён</translation>
    </message>
    <message>
        <source>Another program wrote %1 while the picture was rendered.</source>
        <translation>Пока строился снимок, файл %1 записала другая программа.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Перезаписать</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>The picture was discarded.</source>
        <translation>Снимок отброшен.</translation>
    </message>
    <message>
        <source>The device has not answered for %1 s. Cancel gives the picture up.</source>
        <translation>Устройство не отвечает уже %1 с. «Отмена» прекращает работу над картинкой.</translation>
    </message>
    <message>
        <source>The device did not answer, and the picture was given up.</source>
        <translation>Устройство не ответило, и работа над картинкой прекращена.</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ExportJob</name>
    <message>
        <source>Tracing rays…</source>
        <translation>Трассировка лучей…</translation>
    </message>
    <message>
        <source>Compiling kernels…</source>
        <translation>Компилируются ядра…</translation>
    </message>
    <message>
        <source>Building the world…</source>
        <translation>Построение мира…</translation>
    </message>
    <message>
        <source>Wrote %1</source>
        <translation>Записан файл %1</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::FilmDialog</name>
    <message>
        <source>Export Film</source>
        <translation>Экспорт фильма</translation>
    </message>
    <message>
        <source>Preview (small, to look at the movement)</source>
        <translation>Проба (маленькая, чтобы посмотреть движение)</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Фильм</translation>
    </message>
    <message>
        <source>%1 frames of %2 × %3 pixels, %4 s</source>
        <translation>кадров: %1, по %2 × %3 пикселей, %4 с</translation>
    </message>
    <message>
        <source>Frames stay in a folder beside the film, so that a film that was cancelled goes on and only what changed is rendered again. Names end in .mp4, .mov, .mkv or .webm; a name such as frames/####.png makes frames alone.</source>
        <translation>Кадры остаются в папке рядом с фильмом: прерванный фильм продолжается, и заново считается только то, что изменилось. Имена кончаются на .mp4, .mov, .mkv или .webm; имя вида frames/####.png даёт одни кадры.</translation>
    </message>
    <message>
        <source>Films (*.mp4 *.mov *.mkv *.webm)</source>
        <translation>Фильмы (*.mp4 *.mov *.mkv *.webm)</translation>
    </message>
    <message>
        <source>This is the scene file itself; give the film another name.</source>
        <translation>Это сам файл сцены; дайте фильму другое имя.</translation>
    </message>
    <message>
        <source>Cancelled; the frames that are made are kept.</source>
        <translation>Отменено; готовые кадры сохранены.</translation>
    </message>
    <message>
        <source>The device has not answered for %1 s. Cancel gives the film up.</source>
        <translation>Устройство не отвечает уже %1 с. «Отмена» прекращает работу над фильмом.</translation>
    </message>
    <message>
        <source>The device did not answer, and the film was given up; the frames that are made are kept.</source>
        <translation>Устройство не ответило, и работа над фильмом прекращена; готовые кадры сохранены.</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::FilmJob</name>
    <message>
        <source>Encoding…</source>
        <translation>Кодируется…</translation>
    </message>
    <message>
        <source>Compiling kernels…</source>
        <translation>Компилируются ядра…</translation>
    </message>
    <message>
        <source>Frame %1, %2 of %3</source>
        <translation>Кадр %1, %2 из %3</translation>
    </message>
    <message>
        <source>%1, %2 frames/s</source>
        <translation>%1, %2 кадров/с</translation>
    </message>
    <message>
        <source>Wrote %1: %2 frames rendered, %3 kept</source>
        <translation>Записан %1: кадров посчитано %2, сохранено %3</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ItemPicker</name>
    <message>
        <source>One more lamp</source>
        <translation>Ещё одна лампа</translation>
    </message>
    <message>
        <source>One more balloon</source>
        <translation>Ещё один шар</translation>
    </message>
    <message>
        <source>Remove this lamp</source>
        <translation>Убрать эту лампу</translation>
    </message>
    <message>
        <source>Remove this balloon</source>
        <translation>Убрать этот шар</translation>
    </message>
    <message>
        <source>Balloon %1</source>
        <translation>Шар %1</translation>
    </message>
    <message>
        <source>Lamp %1</source>
        <translation>Лампа %1</translation>
    </message>
    <message>
        <source>No lamp</source>
        <translation>Нет ламп</translation>
    </message>
    <message>
        <source>No model</source>
        <translation>Нет моделей</translation>
    </message>
    <message>
        <source>One more model, from a file</source>
        <translation>Ещё одна модель, из файла</translation>
    </message>
    <message>
        <source>Remove this model</source>
        <translation>Убрать эту модель</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::MainWindow</name>
    <message>
        <source>Controls</source>
        <translation>Настройки</translation>
    </message>
    <message>
        <source>Try Again</source>
        <translation>Ещё раз</translation>
    </message>
    <message>
        <source>Use the Automatic Device</source>
        <translation>Выбрать устройство само</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Взять %1</translation>
    </message>
    <message>
        <source>Unnamed scene</source>
        <translation>Сцена без имени</translation>
    </message>
    <message>
        <source>%1[*] — Aerostat</source>
        <translation>%1[*] — Аэростат</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Файл</translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation>&amp;Новая</translation>
    </message>
    <message>
        <source>&amp;Snowy Mountains</source>
        <translation>&amp;Снежные горы</translation>
    </message>
    <message>
        <source>&amp;Tropical Island</source>
        <translation>&amp;Тропический остров</translation>
    </message>
    <message>
        <source>&amp;Dunes</source>
        <translation>&amp;Дюны</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Открыть…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Сохранить</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Сохранить &amp;как…</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>&amp;Экспорт картины…</translation>
    </message>
    <message>
        <source>Copy &amp;Image</source>
        <translation>Копировать &amp;изображение</translation>
    </message>
    <message>
        <source>Copy as Command &amp;Line</source>
        <translation>Копировать как ко&amp;манду</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Выход</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Правка</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Отменить</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Повторить</translation>
    </message>
    <message>
        <source>Reset &amp;Everything but the Biome</source>
        <translation>&amp;Сбросить всё, кроме биома</translation>
    </message>
    <message>
        <source>Reset Everything</source>
        <translation>Сброс всех настроек</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Вид</translation>
    </message>
    <message>
        <source>&amp;Fit the Window</source>
        <translation>&amp;По размеру окна</translation>
    </message>
    <message>
        <source>Pixel for Pixel (&amp;1:1)</source>
        <translation>Пиксель в пиксель (&amp;1:1)</translation>
    </message>
    <message>
        <source>F&amp;ull Screen</source>
        <translation>Во весь &amp;экран</translation>
    </message>
    <message>
        <source>Go to the &amp;Picture</source>
        <translation>Перейти к &amp;картине</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Камера</translation>
    </message>
    <message>
        <source>From &amp;Outside</source>
        <translation>&amp;Снаружи</translation>
    </message>
    <message>
        <source>From the &amp;Basket</source>
        <translation>Из &amp;корзины</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>С&amp;вободно</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Как в файле</translation>
    </message>
    <message>
        <source>&amp;Put the Balloon by a Click</source>
        <translation>&amp;Поставить шар щелчком</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Справка</translation>
    </message>
    <message>
        <source>&amp;Mouse and Keys</source>
        <translation>&amp;Мышь и клавиши</translation>
    </message>
    <message>
        <source>&amp;About Aerostat</source>
        <translation>&amp;О программе</translation>
    </message>
    <message>
        <source>About Aerostat</source>
        <translation>О программе «Аэростат»</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Aerostat %1&lt;/h3&gt;&lt;p&gt;Pictures of a hot-air balloon before a mountain landscape, ray-traced on OpenCL.&lt;/p&gt;&lt;p&gt;MIT licence. Uses Qt %2 under the LGPL, version 3.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Аэростат %1&lt;/h3&gt;&lt;p&gt;Картины воздушного шара на фоне гор, трассировка лучей на OpenCL.&lt;/p&gt;&lt;p&gt;Лицензия MIT. Использует Qt %2 по лицензии LGPL версии 3.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>building the land…</source>
        <translation>строится рельеф…</translation>
    </message>
    <message>
        <source>building trees…</source>
        <translation>строятся деревья поиска…</translation>
    </message>
    <message>
        <source>compiling kernels…</source>
        <translation>компилируются ядра…</translation>
    </message>
    <message>
        <source>compiling kernels (first run only), %1 %…</source>
        <translation>компилируются ядра (только при первом запуске), %1 %…</translation>
    </message>
    <message>
        <source>uploading…</source>
        <translation>загрузка в устройство…</translation>
    </message>
    <message>
        <source>%1 × %2</source>
        <translation>%1 × %2</translation>
    </message>
    <message>
        <source>1/%1 of the size</source>
        <translation>1/%1 размера</translation>
    </message>
    <message numerus="yes">
        <source>%n sample(s) a pixel</source>
        <translation>
            <numerusform>%n луч на пиксель</numerusform>
            <numerusform>%n луча на пиксель</numerusform>
            <numerusform>%n лучей на пиксель</numerusform>
        </translation>
    </message>
    <message>
        <source>coarse land</source>
        <translation>грубый рельеф</translation>
    </message>
    <message>
        <source>%1 Mrays/s</source>
        <translation>%1 млн лучей/с</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 с</translation>
    </message>
    <message>
        <source>done</source>
        <translation>готово</translation>
    </message>
    <message>
        <source>eye %1 m above ground</source>
        <translation>глаз в %1 м над землёй</translation>
    </message>
    <message>
        <source>%1  ·  %2 s</source>
        <translation>%1  ·  %2 с</translation>
    </message>
    <message>
        <source>Reload and Lose Changes</source>
        <translation>Перечитать и потерять изменения</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <source>&amp;Meadow</source>
        <translation>&amp;Луга</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Шкала времени</translation>
    </message>
    <message>
        <source>Export Fil&amp;m…</source>
        <translation>Экспорт &amp;фильма…</translation>
    </message>
    <message>
        <source>P&amp;lay the Film</source>
        <translation>&amp;Проиграть фильм</translation>
    </message>
    <message>
        <source>Drop %1 on the picture, where it shall stand.</source>
        <translation>Бросьте %1 на картину, туда, где модель должна стоять.</translation>
    </message>
    <message>
        <source>Open as Elevation Data</source>
        <translation>Открыть как данные высот</translation>
    </message>
    <message>
        <source>%1 can be dropped on an envelope, where it becomes artwork.</source>
        <translation>%1 можно бросить на оболочку, где файл станет рисунком.</translation>
    </message>
    <message>
        <source>%1 lies on the envelope.</source>
        <translation>%1 лежит на оболочке.</translation>
    </message>
    <message>
        <source>As a Band</source>
        <translation>Поясом</translation>
    </message>
    <message>
        <source>Artwork as a Band</source>
        <translation>Рисунок поясом</translation>
    </message>
    <message>
        <source>All Around</source>
        <translation>По всей оболочке</translation>
    </message>
    <message>
        <source>Artwork All Around</source>
        <translation>Рисунок по всей оболочке</translation>
    </message>
    <message>
        <source>Put a Model</source>
        <translation>Поставить модель</translation>
    </message>
    <message>
        <source>Models (*.glb *.gltf *.obj *.ply *.stl)</source>
        <translation>Модели (*.glb *.gltf *.obj *.ply *.stl)</translation>
    </message>
    <message>
        <source>Put a &amp;Model…</source>
        <translation>Поставить &amp;модель…</translation>
    </message>
    <message>
        <source>&amp;Remove the Model</source>
        <translation>&amp;Убрать модель</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::MessageBar</name>
    <message>
        <source>Dismiss</source>
        <translation>Скрыть</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ModelControl</name>
    <message>
        <source>%1 can be put into the picture as soon as there is one.</source>
        <translation>%1 можно поставить на картину, как только она появится.</translation>
    </message>
    <message>
        <source>%1 fell into the sky. Drop it where the ground is seen.</source>
        <translation>%1 попал в небо. Бросьте файл туда, где видна земля.</translation>
    </message>
    <message>
        <source>Put %1</source>
        <translation>Поставить %1</translation>
    </message>
    <message>
        <source>Balloons of a festival have no artwork.</source>
        <translation>На шарах фестиваля нет рисунков.</translation>
    </message>
    <message>
        <source>An envelope of a special shape has no artwork.</source>
        <translation>На оболочке особой формы нет рисунков.</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Передвинуть %1</translation>
    </message>
    <message>
        <source>Turn %1</source>
        <translation>Повернуть %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Убрать %1</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::NumberEditor</name>
    <message>
        <source>automatic</source>
        <translation>авто</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::OutputDialog</name>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Записать</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>&amp;Обзор…</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Файл</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Качество</translation>
    </message>
    <message>
        <source>As the scene says</source>
        <translation>Как в сцене</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>Файл %1 уже существует. Заменить его?</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Отмена</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>Отмена…</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::OutputJob</name>
    <message>
        <source>Out of memory</source>
        <translation>Не хватает памяти</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::Panels</name>
    <message>
        <source>&amp;Land</source>
        <translation>&amp;Земля</translation>
    </message>
    <message>
        <source>Li&amp;ght</source>
        <translation>&amp;Свет</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Солнце</translation>
    </message>
    <message>
        <source>&amp;Balloon</source>
        <translation>&amp;Шар</translation>
    </message>
    <message>
        <source>&amp;Picture</source>
        <translation>&amp;Картина</translation>
    </message>
    <message>
        <source>From outside</source>
        <translation>Снаружи</translation>
    </message>
    <message>
        <source>From the basket</source>
        <translation>Из корзины</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Свободно</translation>
    </message>
    <message>
        <source>Where the camera stands: before the balloon, in its basket, or where you move it</source>
        <translation>Где стоит камера: перед шаром, в его корзине или там, куда её переместят</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Выбрать…</translation>
    </message>
    <message>
        <source>Put the Balloon by a Click</source>
        <translation>Поставить шар щелчком</translation>
    </message>
    <message>
        <source>Then click on the ground below the place for the balloon (or Ctrl+click at any time)</source>
        <translation>Затем щёлкните по земле под местом для шара (или Ctrl+щелчок в любое время)</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Вид</translation>
    </message>
    <message>
        <source>Preset</source>
        <translation>Заготовка</translation>
    </message>
    <message>
        <source>Change the Size</source>
        <translation>Изменение размера</translation>
    </message>
    <message>
        <source>Usual sizes</source>
        <translation>Обычные размеры</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Выбрать само</translation>
    </message>
    <message>
        <source>The device that computes the picture. It is not saved with the scene.</source>
        <translation>Что вычисляет картину. К сцене не относится.</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Вычисление</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Устройство</translation>
    </message>
    <message>
        <source>&amp;Materials</source>
        <translation>&amp;Материалы</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Шар</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Лампа</translation>
    </message>
    <message>
        <source>Material of</source>
        <translation>Материал</translation>
    </message>
    <message>
        <source>The camera as in the file, those of the scenes that came with the program in this biome, and such as suit any scene, counted from the balloon</source>
        <translation>Камера как в файле, камеры сцен этого биома, поставляемых с программой, и камеры для любой сцены, отсчитанные от шара</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Как в файле</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Модель</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::PictureView</name>
    <message>
        <source>Picture</source>
        <translation>Картина</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SceneFiles</name>
    <message>
        <source>Scenes (*.json)</source>
        <translation>Сцены (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Все файлы (*)</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Несохранённые изменения</translation>
    </message>
    <message>
        <source>The scene was changed. Save it first?</source>
        <translation>Сцена изменена. Сохранить её?</translation>
    </message>
    <message>
        <source>Open a Scene</source>
        <translation>Открыть сцену</translation>
    </message>
    <message>
        <source>Save the Scene</source>
        <translation>Сохранить сцену</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Н&amp;едавние</translation>
    </message>
    <message>
        <source>Another program changed %1.</source>
        <translation>Другая программа изменила файл %1.</translation>
    </message>
    <message>
        <source>Another program removed or renamed %1. Saving creates it again.</source>
        <translation>Другая программа удалила или переименовала файл %1. При сохранении он будет записан заново.</translation>
    </message>
    <message>
        <source>File Changed</source>
        <translation>Файл изменён</translation>
    </message>
    <message>
        <source>Another program changed %1 since it was opened or saved here.</source>
        <translation>Другая программа изменила файл %1 после того, как он был открыт или сохранён здесь.</translation>
    </message>
    <message>
        <source>Overwriting it loses what that program wrote; reloading it loses the changes made here.</source>
        <translation>При перезаписи пропадёт записанное той программой; при перечитывании пропадут сделанные здесь изменения.</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Перезаписать</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Сохранить как…</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation>Файл %1 уже существует. Заменить его?</translation>
    </message>
    <message>
        <source>Elevation data</source>
        <translation>Данные о высотах</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::ShortcutsDialog</name>
    <message>
        <source>Drag</source>
        <translation>Потянуть</translation>
    </message>
    <message>
        <source>turn around what is looked at; in the basket, look around</source>
        <translation>облететь точку взгляда; в корзине — оглядеться</translation>
    </message>
    <message>
        <source>Right drag, Shift+drag</source>
        <translation>Потянуть правой кнопкой или с Shift</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>оглядеться</translation>
    </message>
    <message>
        <source>Wheel, Page Up, Page Down</source>
        <translation>Колесо, Page Up, Page Down</translation>
    </message>
    <message>
        <source>closer, away</source>
        <translation>ближе, дальше</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Двойной щелчок</translation>
    </message>
    <message>
        <source>aim there</source>
        <translation>навести туда камеру</translation>
    </message>
    <message>
        <source>Ctrl+click</source>
        <translation>Ctrl+щелчок</translation>
    </message>
    <message>
        <source>put the balloon above it</source>
        <translation>поставить шар над этим местом</translation>
    </message>
    <message>
        <source>W A S D</source>
        <translation>W A S D</translation>
    </message>
    <message>
        <source>fly ahead, left, back, right (Shift: fast)</source>
        <translation>лететь вперёд, влево, назад, вправо (Shift — быстро)</translation>
    </message>
    <message>
        <source>Q, E</source>
        <translation>Q, E</translation>
    </message>
    <message>
        <source>down, up</source>
        <translation>вниз, вверх</translation>
    </message>
    <message>
        <source>Arrows, Shift+arrows</source>
        <translation>Стрелки, Shift+стрелки</translation>
    </message>
    <message>
        <source>turn around it, look around</source>
        <translation>облететь, оглядеться</translation>
    </message>
    <message>
        <source>Middle drag</source>
        <translation>Потянуть средней кнопкой</translation>
    </message>
    <message>
        <source>shift the picture at 1:1</source>
        <translation>сдвинуть картину при 1:1</translation>
    </message>
    <message>
        <source>Double click on a name, Ctrl+Backspace</source>
        <translation>Двойной щелчок по названию, Ctrl+Backspace</translation>
    </message>
    <message>
        <source>back to the default</source>
        <translation>вернуть значение по умолчанию</translation>
    </message>
    <message>
        <source>Arrows on the sun&apos;s disc</source>
        <translation>Стрелки на круге солнца</translation>
    </message>
    <message>
        <source>move the sun (Shift: by 10°)</source>
        <translation>сдвинуть солнце (Shift — на 10°)</translation>
    </message>
    <message>
        <source>Ctrl+.</source>
        <translation>Ctrl+.</translation>
    </message>
    <message>
        <source>dismiss a message</source>
        <translation>скрыть сообщение</translation>
    </message>
    <message>
        <source>Mouse and Keys</source>
        <translation>Мышь и клавиши</translation>
    </message>
    <message>
        <source>On the picture</source>
        <translation>На картине</translation>
    </message>
    <message>
        <source>On the controls</source>
        <translation>На настройках</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Щелчок</translation>
    </message>
    <message>
        <source>pick a model</source>
        <translation>выбрать модель</translation>
    </message>
    <message>
        <source>Drag, Shift+drag on the picked model</source>
        <translation>Протянуть, Shift+протянуть выбранную модель</translation>
    </message>
    <message>
        <source>move it, turn it</source>
        <translation>передвинуть её, повернуть её</translation>
    </message>
    <message>
        <source>Delete, Escape</source>
        <translation>Delete, Escape</translation>
    </message>
    <message>
        <source>remove the picked model, let it go</source>
        <translation>убрать выбранную модель, отпустить её</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SunDisc</name>
    <message>
        <source>Sun</source>
        <translation>Солнце</translation>
    </message>
    <message>
        <source>Drag the sun: the rim is the horizon, the middle the zenith, north is up. Double-click for the default.</source>
        <translation>Тяните солнце: край — горизонт, середина — зенит, север наверху. Двойной щелчок вернёт значение по умолчанию.</translation>
    </message>
    <message>
        <source>N</source>
        <comment>north</comment>
        <translation>С</translation>
    </message>
    <message>
        <source>E</source>
        <comment>east</comment>
        <translation>В</translation>
    </message>
    <message>
        <source>S</source>
        <comment>south</comment>
        <translation>Ю</translation>
    </message>
    <message>
        <source>W</source>
        <comment>west</comment>
        <translation>З</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::SunPanel</name>
    <message>
        <source>By date, time and place</source>
        <translation>По дате, времени и месту</translation>
    </message>
    <message>
        <source>The day that gives the sun its place</source>
        <translation>День, в который солнце стоит именно так</translation>
    </message>
    <message>
        <source>Time of that day, by the clock of the place</source>
        <translation>Время того дня по часам этого места</translation>
    </message>
    <message>
        <source>UTC </source>
        <comment>before an offset in hours</comment>
        <translation>UTC </translation>
    </message>
    <message>
        <source> h</source>
        <translation> ч</translation>
    </message>
    <message>
        <source>How far that clock is ahead of universal time</source>
        <translation>На сколько эти часы впереди всемирного времени</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Дата</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Часы</translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation>Широта</translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation>Долгота</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Азимут</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Высота над горизонтом</translation>
    </message>
    <message>
        <source>Move the Sun</source>
        <translation>Перемещение солнца</translation>
    </message>
    <message>
        <source>Move the Sun by Date</source>
        <translation>Солнце по дате</translation>
    </message>
    <message>
        <source>Reset the Sun</source>
        <translation>Сброс солнца</translation>
    </message>
</context>
<context>
    <name>aerostat::viewer::TimelinePanel</name>
    <message>
        <source>Play</source>
        <translation>Проиграть</translation>
    </message>
    <message>
        <source>Show the still picture</source>
        <translation>Показать неподвижную картину</translation>
    </message>
    <message>
        <source>Set Key</source>
        <translation>Поставить ключ</translation>
    </message>
    <message>
        <source>Remove Key</source>
        <translation>Убрать ключ</translation>
    </message>
    <message>
        <source>Export Film…</source>
        <translation>Экспорт фильма…</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Кадр</translation>
    </message>
    <message>
        <source>Value with keys</source>
        <translation>Значение с ключами</translation>
    </message>
    <message>
        <source>The value whose keys are edited, by its JSON pointer</source>
        <translation>Значение, ключи которого правятся, по его указателю JSON</translation>
    </message>
    <message>
        <source>Value at this frame</source>
        <translation>Значение в этом кадре</translation>
    </message>
    <message>
        <source>The value at this frame; Enter makes it a key</source>
        <translation>Значение в этом кадре; Enter делает его ключом</translation>
    </message>
    <message>
        <source>Key of %1</source>
        <translation>Ключ %1</translation>
    </message>
    <message>
        <source>frame %1 of %2, %3 s</source>
        <translation>кадр %1 из %2, %3 с</translation>
    </message>
    <message>
        <source>, %1 frames/s</source>
        <translation>, %1 кадров/с</translation>
    </message>
    <message>
        <source>still picture</source>
        <translation>неподвижная картина</translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Sets up a picture of aerostat by eye.</source>
        <translation>Настройка картин aerostat на глаз.</translation>
    </message>
    <message>
        <source>Scene file to open</source>
        <translation>Файл сцены, который открыть</translation>
    </message>
    <message>
        <source>What computes, as of aerostat render</source>
        <translation>Что вычисляет, как у aerostat render</translation>
    </message>
    <message>
        <source>Expected one scene at most, found %1: %2.</source>
        <translation>Ожидается не больше одной сцены, получено %1: %2.</translation>
    </message>
    <message>
        <source>aerostat-viewer --help lists what can be asked for.</source>
        <translation>aerostat-viewer --help показывает все параметры.</translation>
    </message>
</context>
</TS>
