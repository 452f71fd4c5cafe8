<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>ColorPreset</name>
    <message>
        <source>Ivory black</source>
        <translation>Elfenbeinschwarz</translation>
    </message>
    <message>
        <source>Sepia</source>
        <translation>Sepia</translation>
    </message>
    <message>
        <source>Sanguine</source>
        <translation>Rötel</translation>
    </message>
    <message>
        <source>Cyanotype</source>
        <translation>Cyanotypie</translation>
    </message>
    <message>
        <source>Indigo and gold</source>
        <translation>Indigo und Gold</translation>
    </message>
    <message>
        <source>Verdigris</source>
        <translation>Grünspan</translation>
    </message>
    <message>
        <source>Ultramarine and flesh</source>
        <translation>Ultramarin und Inkarnat</translation>
    </message>
    <message>
        <source>Night garden</source>
        <translation>Nachtgarten</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>Similarity</source>
        <translation>Ähnlichkeit</translation>
    </message>
    <message>
        <source>How little the texture resembles the strip, frame by frame</source>
        <translation>Wie wenig die Textur dem Streifen ähnelt, Bild für Bild</translation>
    </message>
    <message>
        <source>Shading</source>
        <translation>Schattierung</translation>
    </message>
    <message>
        <source>How far the texture&apos;s shade is from the light, frame by frame</source>
        <translation>Wie weit der Ton der Textur vom Licht abweicht, Bild für Bild</translation>
    </message>
    <message>
        <source>Image space</source>
        <translation>Bildraum</translation>
    </message>
    <message>
        <source>How much each pixel&apos;s texture changes from the frame before</source>
        <translation>Wie sehr sich die Textur jedes Pixels gegenüber dem vorigen Bild ändert</translation>
    </message>
    <message>
        <source>Object space</source>
        <translation>Objektraum</translation>
    </message>
    <message>
        <source>How much the texture of each place of the object changes from the frame before</source>
        <translation>Wie sehr sich die Textur jeder Stelle des Objekts gegenüber dem vorigen Bild ändert</translation>
    </message>
    <message>
        <source>rotation (degrees)</source>
        <translation>Drehung (Grad)</translation>
    </message>
    <message>
        <source>block size n (px)</source>
        <translation>Blockgröße n (px)</translation>
    </message>
    <message>
        <source>scale factor</source>
        <translation>Skalierungsfaktor</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>similarity error</source>
        <translation>Ähnlichkeitsfehler</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Ambient occlusion</source>
        <translation>Umgebungsverdeckung</translation>
    </message>
    <message>
        <source>Another number gives another arrangement of the same paint.</source>
        <translation>Eine andere Zahl ergibt eine andere Anordnung derselben Farbe.</translation>
    </message>
    <message>
        <source>Atlas</source>
        <translation>Atlas</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>Grundlage</translation>
    </message>
    <message>
        <source>Between keyframes: linear fades softly and greys a little half way, preserving keeps the contrast of the strokes.</source>
        <translation>Zwischen Schlüsselbildern: linear blendet weich und wird auf halbem Weg etwas grau, erhaltend bewahrt den Kontrast der Striche.</translation>
    </message>
    <message>
        <source>Between the parts of the texture, so that small versions of it don&apos;t mix them; less where there are too many parts.</source>
        <translation>Zwischen den Teilen der Textur, damit kleine Fassungen sie nicht mischen; weniger, wo es zu viele Teile gibt.</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Block</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>Cosine of the angle beyond which a view does not paint a face; also the least weight of a view.</source>
        <translation>Kosinus des Winkels, ab dem eine Ansicht eine Fläche nicht mehr malt; zugleich das kleinste Gewicht einer Ansicht.</translation>
    </message>
    <message>
        <source>Dilate</source>
        <translation>Ausdehnen</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Enlarge it a little, to 1.2 say, when a strongly curved colour path loses colours.</source>
        <translation>Etwas vergrößern, etwa auf 1,2, wenn ein stark gekrümmter Farbweg Farben verliert.</translation>
    </message>
    <message>
        <source>Enlarges or shrinks the strip; strokes on the object are as large as in the strip.</source>
        <translation>Vergrößert oder verkleinert den Streifen; Striche auf dem Objekt sind so groß wie im Streifen.</translation>
    </message>
    <message>
        <source>Fits the speed of the colour change to the strip; off, the drawn curve is used.</source>
        <translation>Passt das Tempo des Farbwechsels an den Streifen an; aus gilt die gezeichnete Kurve.</translation>
    </message>
    <message>
        <source>Flattest angle</source>
        <translation>Flachster Winkel</translation>
    </message>
    <message>
        <source>Follow camera</source>
        <translation>Kamera folgen</translation>
    </message>
    <message>
        <source>Follow zoom</source>
        <translation>Zoom folgen</translation>
    </message>
    <message>
        <source>Frames from one keyframe&apos;s texture to the next: more is calmer and faster, less follows the light and the camera more closely.</source>
        <translation>Bilder von der Textur eines Schlüsselbilds zur nächsten: mehr ist ruhiger und schneller, weniger folgt Licht und Kamera genauer.</translation>
    </message>
    <message>
        <source>How far ambient occlusion looks around, of the scene&apos;s radius</source>
        <translation>Wie weit die Umgebungsverdeckung um sich blickt, vom Radius der Szene</translation>
    </message>
    <message>
        <source>How far from its own light a piece of the sample may be used: more gives better seams, less follows the light more closely.</source>
        <translation>Wie weit von seiner eigenen Helligkeit ein Stück der Probe verwendet werden darf: mehr ergibt bessere Nähte, weniger folgt dem Licht genauer.</translation>
    </message>
    <message>
        <source>How far pieces overlap to hide their seams; 0 takes a sixth of the block.</source>
        <translation>Wie weit sich Stücke überlappen, um ihre Nähte zu verbergen; 0 nimmt ein Sechstel des Blocks.</translation>
    </message>
    <message>
        <source>How levels repeat: mixed by the report&apos;s round mask, which blurs, or cut along a seam, which does not.</source>
        <translation>Wie sich Stufen wiederholen: gemischt durch die runde Maske des Berichts, die verwischt, oder entlang einer Naht geschnitten, die es nicht tut.</translation>
    </message>
    <message>
        <source>How many of the most similar places of the sample say which shade a pixel&apos;s texture is meant for.</source>
        <translation>Wie viele der ähnlichsten Stellen der Probe sagen, für welchen Ton die Textur eines Pixels gedacht ist.</translation>
    </message>
    <message>
        <source>How many pixels are drawn by chance and measured; 0 is every one.</source>
        <translation>Wie viele Pixel zufällig gezogen und gemessen werden; 0 heißt alle.</translation>
    </message>
    <message>
        <source>How much darker corners and contacts are painted; 0 is off</source>
        <translation>Wie viel dunkler Ecken und Berührungen gemalt werden; 0 ist aus</translation>
    </message>
    <message>
        <source>How much worse than the best fit a piece may be: more gives more variety, less gives better seams.</source>
        <translation>Wie viel schlechter als das beste ein Stück passen darf: mehr ergibt mehr Vielfalt, weniger bessere Nähte.</translation>
    </message>
    <message>
        <source>How often the scan is turned by 90° clockwise, until dark and light lie left and right.</source>
        <translation>Wie oft der Scan um 90° im Uhrzeigersinn gedreht wird, bis Dunkel links und Hell rechts liegt.</translation>
    </message>
    <message>
        <source>How strongly a frame stays close to the one before, against how well its pieces fit together.</source>
        <translation>Wie stark ein Bild dem vorigen nahe bleibt, gegenüber dem Zusammenpassen seiner Stücke.</translation>
    </message>
    <message>
        <source>How the frames of an image-based animation hang together: each by itself, close to the one before, blended from keyframe to keyframe, or moved with the surface.</source>
        <translation>Wie die Bilder einer bildbasierten Animation zusammenhängen: jedes für sich, nahe am vorigen, von Schlüsselbild zu Schlüsselbild überblendet oder mit der Oberfläche bewegt.</translation>
    </message>
    <message>
        <source>How the views&apos; textures meet: linear, or with the contrast kept, which is for views that don&apos;t agree (without Propagate).</source>
        <translation>Wie die Texturen der Ansichten aufeinandertreffen: linear oder mit erhaltenem Kontrast, für Ansichten, die nicht übereinstimmen (ohne Fortsetzen).</translation>
    </message>
    <message>
        <source>How views flatten the object; orthographic keeps strokes of one size and carries them exactly from view to view.</source>
        <translation>Wie Ansichten das Objekt abbilden; orthografisch hält Striche gleich groß und trägt sie genau von Ansicht zu Ansicht.</translation>
    </message>
    <message>
        <source>Image-based</source>
        <translation>Bildbasiert</translation>
    </message>
    <message>
        <source>Keyframe distance</source>
        <translation>Schlüsselabstand</translation>
    </message>
    <message>
        <source>Let a view go on from what other views painted on the faces that they share, so that strokes agree where views meet.</source>
        <translation>Eine Ansicht setzt fort, was andere auf gemeinsame Flächen gemalt haben, damit Striche übereinstimmen, wo Ansichten sich treffen.</translation>
    </message>
    <message>
        <source>Let the parts of the texture grow until they meet; off leaves black between them.</source>
        <translation>Die Teile der Textur wachsen lassen, bis sie sich berühren; aus bleibt Schwarz dazwischen.</translation>
    </message>
    <message>
        <source>Let the views nearest to the camera count more: crisper where views differ, but strokes change as the camera moves.</source>
        <translation>Ansichten nahe der Kamera zählen mehr: schärfer, wo Ansichten sich unterscheiden, doch Striche ändern sich mit der Kamera.</translation>
    </message>
    <message>
        <source>Level size</source>
        <translation>Stufengröße</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Look for pieces at half the size first: several times faster, with seams that fit a little less well.</source>
        <translation>Stücke zuerst in halber Größe suchen: um ein Vielfaches schneller, mit etwas schlechter passenden Nähten.</translation>
    </message>
    <message>
        <source>Map size</source>
        <translation>Kartengröße</translation>
    </message>
    <message>
        <source>Match speed</source>
        <translation>Tempo anpassen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Moved texture</source>
        <translation>Bewegte Textur</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>Occlusion radius</source>
        <translation>Verdeckungsradius</translation>
    </message>
    <message>
        <source>Overlap</source>
        <translation>Überlappung</translation>
    </message>
    <message>
        <source>Padding</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Propagate</source>
        <translation>Fortsetzen</translation>
    </message>
    <message>
        <source>Quarter turns</source>
        <translation>Vierteldrehungen</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Scale the strokes with the object, in octaves that cross-fade</source>
        <translation>Striche mit dem Objekt skalieren, in Oktaven, die ineinander übergehen</translation>
    </message>
    <message>
        <source>Search scale</source>
        <translation>Suchradius</translation>
    </message>
    <message>
        <source>Sections the strip is divided into, from dark to light; each becomes a level of texture.</source>
        <translation>Abschnitte, in die der Streifen von dunkel nach hell geteilt wird; jeder wird eine Stufe der Textur.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startzahl</translation>
    </message>
    <message>
        <source>Seed of the pixels that are drawn.</source>
        <translation>Startzahl der gezogenen Pixel.</translation>
    </message>
    <message>
        <source>Shading, mean absolute</source>
        <translation>Schattierung, mittlerer Betrag</translation>
    </message>
    <message>
        <source>Shading, mean squared</source>
        <translation>Schattierung, mittleres Quadrat</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Side of a level; larger repeats less often.</source>
        <translation>Seite einer Stufe; größer wiederholt sich seltener.</translation>
    </message>
    <message>
        <source>Side of each view&apos;s square map of texture.</source>
        <translation>Seite der quadratischen Texturkarte jeder Ansicht.</translation>
    </message>
    <message>
        <source>Side of the blocks whose colours and edges are compared.</source>
        <translation>Seite der Blöcke, deren Farben und Kanten verglichen werden.</translation>
    </message>
    <message>
        <source>Side of the pieces the texture is cut into; larger keeps longer strokes whole, smaller follows the light more closely.</source>
        <translation>Seite der Stücke, in die die Textur geschnitten wird; größer hält längere Striche ganz, kleiner folgt dem Licht genauer.</translation>
    </message>
    <message>
        <source>Stroke density</source>
        <translation>Strichdichte</translation>
    </message>
    <message>
        <source>Surfaces cast shadows on each other</source>
        <translation>Flächen werfen Schatten aufeinander</translation>
    </message>
    <message>
        <source>Swaps left and right, for scans whose light end is at the left.</source>
        <translation>Vertauscht links und rechts, für Scans mit dem hellen Ende links.</translation>
    </message>
    <message>
        <source>Temporal weight</source>
        <translation>Zeitgewicht</translation>
    </message>
    <message>
        <source>Temporal, image space</source>
        <translation>Zeitlich, Bildraum</translation>
    </message>
    <message>
        <source>Temporal, object space</source>
        <translation>Zeitlich, Objektraum</translation>
    </message>
    <message>
        <source>Texture pixels per screen pixel; larger makes smaller strokes</source>
        <translation>Texturpixel pro Bildschirmpixel; größer macht kleinere Striche</translation>
    </message>
    <message>
        <source>Texture similarity</source>
        <translation>Texturähnlichkeit</translation>
    </message>
    <message>
        <source>The texture&apos;s side: as many pixels hold the paint of the whole mesh.</source>
        <translation>Die Seite der Textur: So viele Pixel tragen die Farbe des ganzen Netzes.</translation>
    </message>
    <message>
        <source>Tiling</source>
        <translation>Kachelung</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>View-aligned</source>
        <translation>Blickgerichtet</translation>
    </message>
    <message>
        <source>View-dependent</source>
        <translation>Blickabhängig</translation>
    </message>
    <message>
        <source>Viewpoints around the object; hidden parts get further ones.</source>
        <translation>Blickpunkte um das Objekt; verdeckte Teile bekommen weitere.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>What is taken off the paint before it becomes texture: a section&apos;s mean colour, or the gradient.</source>
        <translation>Was von der Farbe abgezogen wird, bevor sie Textur wird: die mittlere Farbe eines Abschnitts oder der Verlauf.</translation>
    </message>
    <message>
        <source>What moves with the surface: the keyframes&apos; textures, or the frame before as what the next one stays close to.</source>
        <translation>Was sich mit der Oberfläche bewegt: die Texturen der Schlüsselbilder oder das vorige Bild, dem das nächste nahe bleibt.</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>blocks</source>
        <translation>Blöcke</translation>
    </message>
    <message>
        <source>diagonal</source>
        <translation>diagonal</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>independent</source>
        <translation>unabhängig</translation>
    </message>
    <message>
        <source>keyframes</source>
        <translation>Schlüsselbilder</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>lit</source>
        <translation>beleuchtet</translation>
    </message>
    <message>
        <source>lit: the colours as they are in the scene&apos;s light. texture: the paint in an even middle light, for a renderer with lights of its own.</source>
        <translation>beleuchtet: die Farben im Licht der Szene. Textur: die Farbe in gleichmäßigem mittlerem Licht, für Renderer mit eigenen Lichtern.</translation>
    </message>
    <message>
        <source>mask</source>
        <translation>Maske</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>orthografisch</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivisch</translation>
    </message>
    <message>
        <source>preserving</source>
        <translation>erhaltend</translation>
    </message>
    <message>
        <source>previous</source>
        <translation>voriges Bild</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>random</source>
        <translation>zufällig</translation>
    </message>
    <message>
        <source>reprojected</source>
        <translation>mitbewegt</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>Naht</translation>
    </message>
    <message>
        <source>section</source>
        <translation>Abschnitt</translation>
    </message>
    <message>
        <source>symmetric</source>
        <translation>symmetrisch</translation>
    </message>
    <message>
        <source>texel/px</source>
        <translation>Texel/px</translation>
    </message>
    <message>
        <source>texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>directional</source>
        <translation>gerichtet</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Far away in a direction, or at a point in the scene</source>
        <translation>Weit weg in einer Richtung oder an einem Punkt der Szene</translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation>Stärke</translation>
    </message>
    <message>
        <source>How much it gives; lights add up, and L ends at 1</source>
        <translation>Wie viel es gibt; Lichter addieren sich, und L endet bei 1</translation>
    </message>
    <message>
        <source>Wrap</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>Light goes around to the far side, (1 + n·l)/2; off: half is dark</source>
        <translation>Licht reicht um die abgewandte Seite herum, (1 + n·l)/2; aus: die Hälfte ist dunkel</translation>
    </message>
    <message>
        <source>Movement</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>approach</source>
        <translation>Annäherung</translation>
    </message>
    <message>
        <source>turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>What moves: the camera comes nearer, it goes around, or what the timeline&apos;s keys say.</source>
        <translation>Was sich bewegt: die Kamera kommt näher, sie geht herum, oder was die Zeitleiste sagt.</translation>
    </message>
    <message>
        <source>As reported</source>
        <translation>Wie im Bericht</translation>
    </message>
    <message>
        <source>Let methods animate as in the report: each image-based frame close to the one before, a 3D texture that keeps its scale. Off: as this project says.</source>
        <translation>Verfahren animieren wie im Bericht: jedes bildbasierte Bild nahe am vorigen, eine 3D-Textur, die ihren Maßstab behält. Aus: wie dieses Projekt es sagt.</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How many frames are painted and measured.</source>
        <translation>Wie viele Bilder gemalt und gemessen werden.</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Umlauf</translation>
    </message>
    <message>
        <source>In how many frames a turntable goes around.</source>
        <translation>In wie vielen Bildern ein Drehteller herumgeht.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Width and height of the frames.</source>
        <translation>Breite und Höhe der Bilder.</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Startzahlen</translation>
    </message>
    <message>
        <source>How many syntheses are averaged; their spread tells how sure the figures are.</source>
        <translation>Über wie viele Synthesen gemittelt wird; ihre Streuung zeigt, wie sicher die Zahlen sind.</translation>
    </message>
    <message>
        <source>How many pixels are drawn by chance and measured in each frame.</source>
        <translation>Wie viele Pixel in jedem Bild zufällig gezogen und gemessen werden.</translation>
    </message>
    <message>
        <source>MB</source>
        <translation>MB</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Memory that reading one file may take</source>
        <translation>Speicher, den das Lesen einer Datei brauchen darf</translation>
    </message>
    <message>
        <source>Seconds that reading one file may take</source>
        <translation>Sekunden, die das Lesen einer Datei dauern darf</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>process %1 on %2</source>
        <translation>Prozess %1 auf %2</translation>
    </message>
</context>
<context>
    <name>chiaro::app::AnimationDialog</name>
    <message>
        <source>Render Animation</source>
        <translation>Animation rendern</translation>
    </message>
    <message>
        <source>%1 to %2, %3 a second</source>
        <translation>%1 bis %2, %3 pro Sekunde</translation>
    </message>
    <message>
        <source>Set in the Timeline dock</source>
        <translation>Wird in der Zeitleiste eingestellt</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Transparenter Hintergrund</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Dateien</translation>
    </message>
    <message>
        <source>Pictures: name.####.png, where #### becomes the frame&apos;s number. A video: .mp4, .webm, or .mkv, which loses nothing.</source>
        <translation>Bilder: name.####.png, wobei #### zur Bildnummer wird. Ein Video: .mp4, .webm oder das verlustfreie .mkv.</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr);;Videos (*.mp4 *.webm *.mkv)</source>
        <translation>Bilder (*.png *.tif *.exr);;Videos (*.mp4 *.webm *.mkv)</translation>
    </message>
    <message>
        <source>Also light, ids, depth, normals, motion and texture</source>
        <translation>Auch Licht, IDs, Tiefe, Normalen, Bewegung und Textur</translation>
    </message>
    <message>
        <source>As OpenEXR pictures, ids as PNG, in a folder beside the frames, for compositing</source>
        <translation>Als OpenEXR-Bilder, IDs als PNG, in einem Ordner neben den Bildern, für das Compositing</translation>
    </message>
    <message>
        <source>Keep frames that are finished</source>
        <translation>Fertige Bilder behalten</translation>
    </message>
    <message>
        <source>Goes on after an interruption: frames that are there already, whole and of just these settings,
are not made again. All others are replaced.</source>
        <translation>Macht nach einer Unterbrechung weiter: Bilder, die schon ganz und mit eben diesen
Einstellungen da sind, werden nicht neu gemacht. Alle anderen werden ersetzt.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Autosave</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
</context>
<context>
    <name>chiaro::app::CameraMoves</name>
    <message>
        <source>&amp;Previous Camera</source>
        <translation>&amp;Vorige Kamera</translation>
    </message>
    <message>
        <source>Ne&amp;xt Camera</source>
        <translation>Nä&amp;chste Kamera</translation>
    </message>
</context>
<context>
    <name>chiaro::app::CompareTools</name>
    <message>
        <source>Single</source>
        <translation>Einzeln</translation>
    </message>
    <message>
        <source>One method fills the viewport</source>
        <translation>Ein Verfahren füllt die Ansicht</translation>
    </message>
    <message>
        <source>Side by Side</source>
        <translation>Nebeneinander</translation>
    </message>
    <message>
        <source>Two or three methods beside each other</source>
        <translation>Zwei oder drei Verfahren nebeneinander</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>Trennlinie</translation>
    </message>
    <message>
        <source>One method on each side of a line, which is dragged and turned</source>
        <translation>Ein Verfahren auf jeder Seite einer Linie, die man zieht und dreht</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>One method laid over the other</source>
        <translation>Ein Verfahren über das andere gelegt</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Differenz</translation>
    </message>
    <message>
        <source>How far two methods are apart; black where they are equal</source>
        <translation>Wie weit zwei Verfahren auseinander sind; schwarz, wo sie gleich sind</translation>
    </message>
    <message>
        <source>%1 (%2)
%3</source>
        <translation>%1 (%2)
%3</translation>
    </message>
    <message>
        <source>Move the wipe, or lessen the blend or the gain</source>
        <translation>Trennlinie verschieben, Überblendung oder Verstärkung verringern</translation>
    </message>
    <message>
        <source>Move the wipe, or raise the blend or the gain</source>
        <translation>Trennlinie verschieben, Überblendung oder Verstärkung erhöhen</translation>
    </message>
    <message>
        <source>&amp;Less</source>
        <translation>&amp;Weniger</translation>
    </message>
    <message>
        <source>&amp;More</source>
        <translation>&amp;Mehr</translation>
    </message>
    <message>
        <source>Turn Wipe &amp;Left</source>
        <translation>Linie nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn the wipe&apos;s line by 5° counter-clockwise</source>
        <translation>Die Trennlinie um 5° gegen den Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>Turn Wipe &amp;Right</source>
        <translation>Linie nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>Turn the wipe&apos;s line by 5° clockwise</source>
        <translation>Die Trennlinie um 5° im Uhrzeigersinn drehen</translation>
    </message>
    <message>
        <source>S&amp;wap Methods</source>
        <translation>Verfahren &amp;tauschen</translation>
    </message>
    <message>
        <source>Let the first and the second method change places</source>
        <translation>Das erste und das zweite Verfahren tauschen die Plätze</translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation>&amp;Vergleichen</translation>
    </message>
    <message>
        <source>&amp;First Method</source>
        <translation>&amp;Erstes Verfahren</translation>
    </message>
    <message>
        <source>Se&amp;cond Method</source>
        <translation>&amp;Zweites Verfahren</translation>
    </message>
    <message>
        <source>&amp;Third Method</source>
        <translation>&amp;Drittes Verfahren</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Compare: %1</source>
        <translation>Vergleich: %1</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ComparisonPane</name>
    <message>
        <source>Measure to see how every method does, frame by frame.</source>
        <translation>Messen zeigt Bild für Bild, wie gut jedes Verfahren ist.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ComparisonTable</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>The mean over %L1 pixels, and its standard error</source>
        <translation>Mittel über %L1 Pixel und sein Standardfehler</translation>
    </message>
    <message>
        <source>
The smallest of the row</source>
        <translation>
Der kleinste Wert der Zeile</translation>
    </message>
    <message>
        <source>What the report found with its own paints and meshes</source>
        <translation>Was der Bericht mit eigenen Farben und Netzen fand</translation>
    </message>
    <message>
        <source>report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>chiaro::app::DistortionStudy</name>
    <message>
        <source>The strip changed while it was measured: measure again</source>
        <translation>Der Streifen wurde während der Messung geändert: bitte erneut messen</translation>
    </message>
    <message>
        <source>Studying distortions</source>
        <translation>Verzerrungen werden untersucht</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Document</name>
    <message>
        <source>Untitled</source>
        <translation>Unbenannt</translation>
    </message>
    <message>
        <source>Cut Strip</source>
        <translation>Streifen zuschneiden</translation>
    </message>
    <message>
        <source>Change Gradient</source>
        <translation>Verlauf ändern</translation>
    </message>
    <message>
        <source>Recolour</source>
        <translation>Umfärben</translation>
    </message>
    <message>
        <source>Change Levels</source>
        <translation>Stufen ändern</translation>
    </message>
    <message>
        <source>Change Strokes</source>
        <translation>Striche ändern</translation>
    </message>
    <message>
        <source>Change Method</source>
        <translation>Verfahren wechseln</translation>
    </message>
    <message>
        <source>Change Synthesis</source>
        <translation>Synthese ändern</translation>
    </message>
    <message>
        <source>Change Coherence</source>
        <translation>Kohärenz ändern</translation>
    </message>
    <message>
        <source>Change Blending</source>
        <translation>Überblendung ändern</translation>
    </message>
    <message>
        <source>Change Shadows</source>
        <translation>Schatten ändern</translation>
    </message>
    <message>
        <source>Move Light</source>
        <translation>Licht verschieben</translation>
    </message>
    <message>
        <source>Turn Light</source>
        <translation>Licht drehen</translation>
    </message>
    <message>
        <source>Change View Planning</source>
        <translation>Ansichtsplanung ändern</translation>
    </message>
    <message>
        <source>Add View</source>
        <translation>Ansicht hinzufügen</translation>
    </message>
    <message>
        <source>Lock View</source>
        <translation>Ansicht festhalten</translation>
    </message>
    <message>
        <source>Move View</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Remove View</source>
        <translation>Ansicht entfernen</translation>
    </message>
    <message>
        <source>Remove Object</source>
        <translation>Objekt entfernen</translation>
    </message>
    <message>
        <source>Remove Objects</source>
        <translation>Objekte entfernen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Add Sample</source>
        <translation>Probe hinzufügen</translation>
    </message>
    <message>
        <source>Remove Sample</source>
        <translation>Probe entfernen</translation>
    </message>
    <message>
        <source>Paint Everything</source>
        <translation>Alles bemalen</translation>
    </message>
    <message>
        <source>Open Mesh</source>
        <translation>Netz öffnen</translation>
    </message>
    <message>
        <source>Add Mesh</source>
        <translation>Netz hinzufügen</translation>
    </message>
    <message>
        <source>Apply Preset</source>
        <translation>Vorlage anwenden</translation>
    </message>
    <message>
        <source>Place Views</source>
        <translation>Ansichten setzen</translation>
    </message>
    <message>
        <source>Rename Sample</source>
        <translation>Probe umbenennen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::EditMenu</name>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::EmptyHint</name>
    <message>
        <source>Drop a strip of paint and a mesh here,
or open them from the File menu</source>
        <translation>Einen Farbstreifen und ein Netz hierher ziehen
oder im Menü Datei öffnen</translation>
    </message>
    <message>
        <source>Drop a strip of paint here, or open one from the File menu</source>
        <translation>Einen Farbstreifen hierher ziehen oder im Menü Datei öffnen</translation>
    </message>
    <message>
        <source>Drop a mesh here, or open one from the File menu</source>
        <translation>Ein Netz hierher ziehen oder im Menü Datei öffnen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ExportDialog</name>
    <message>
        <source>Export Picture</source>
        <translation>Bild exportieren</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Transparenter Hintergrund</translation>
    </message>
    <message>
        <source>Strokes as large as in the window</source>
        <translation>Striche so groß wie im Fenster</translation>
    </message>
    <message>
        <source>On: the picture looks as the viewport does, at any size.
Off: strokes are as many pixels wide as in the strip.</source>
        <translation>An: Das Bild sieht in jeder Größe wie die Ansicht aus.
Aus: Striche sind so viele Pixel breit wie im Streifen.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.tiff *.jpg *.jpeg *.webp *.exr)</source>
        <translation>Bilder (*.png *.tif *.tiff *.jpg *.jpeg *.webp *.exr)</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Exporter</name>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
    <message>
        <source>The picture is at %1</source>
        <translation>Das Bild liegt unter %1</translation>
    </message>
    <message>
        <source>Rendering %1</source>
        <translation>%1 wird gerendert</translation>
    </message>
    <message>
        <source>The animation is at %1</source>
        <translation>Die Animation liegt unter %1</translation>
    </message>
    <message>
        <source>The painted mesh is at %1</source>
        <translation>Das bemalte Netz liegt unter %1</translation>
    </message>
    <message>
        <source> · its texture has so many parts that they lie %1 px apart</source>
        <translation> · seine Textur hat so viele Teile, dass sie nur %1 px Abstand haben</translation>
    </message>
    <message>
        <source>Export Relightable Page</source>
        <translation>Beleuchtbare Seite exportieren</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>The page is at %1 · open it in any browser</source>
        <translation>Die Seite liegt unter %1 · in jedem Browser zu öffnen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::FaceGroups</name>
    <message>
        <source>Colouring face groups</source>
        <translation>Flächengruppen werden gefärbt</translation>
    </message>
</context>
<context>
    <name>chiaro::app::FileMenu</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation>&amp;Neues Projekt</translation>
    </message>
    <message>
        <source>&amp;Open Project…</source>
        <translation>Projekt ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Strip…</source>
        <translation>&amp;Streifen öffnen …</translation>
    </message>
    <message>
        <source>Open &amp;Mesh…</source>
        <translation>N&amp;etz öffnen …</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>S&amp;peichern</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Export Picture…</source>
        <translation>&amp;Bild exportieren …</translation>
    </message>
    <message>
        <source>Export M&amp;esh…</source>
        <translation>Ne&amp;tz exportieren …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Collect Files…</source>
        <translation>Dateien &amp;sammeln …</translation>
    </message>
    <message>
        <source>Copies the project with all its scans and meshes into one folder</source>
        <translation>Kopiert das Projekt mit allen Scans und Netzen in einen Ordner</translation>
    </message>
    <message>
        <source>Export &amp;Relightable Page…</source>
        <translation>Be&amp;leuchtbare Seite exportieren …</translation>
    </message>
</context>
<context>
    <name>chiaro::app::FirstHints</name>
    <message>
        <source>&lt;b&gt;Look around.&lt;/b&gt; Drag beside the skull to turn it, use the wheel to come nearer. Shift with the right button turns the light.</source>
        <translation>&lt;b&gt;Umsehen.&lt;/b&gt; Neben dem Schädel ziehen dreht ihn, das Mausrad holt ihn näher. Umschalt mit der rechten Taste dreht das Licht.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Bring your own.&lt;/b&gt; Drop a scan of paint, dark at the left and light at the right, and a mesh on this window.</source>
        <translation>&lt;b&gt;Eigenes mitbringen.&lt;/b&gt; Den Scan eines Farbstreifens, links dunkel und rechts hell, und ein Netz auf dieses Fenster ziehen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Choose how the paint is laid on&lt;/b&gt; with the keys 1, 2 and 3, and recolour it in &lt;i&gt;Gradient Curve&lt;/i&gt;. F1 tells about the dock you are in.</source>
        <translation>&lt;b&gt;Den Auftrag der Farbe wählen&lt;/b&gt; mit den Tasten 1, 2 und 3, und in &lt;i&gt;Verlaufskurve&lt;/i&gt; umfärben. F1 erklärt das Dock, in dem man ist.</translation>
    </message>
    <message>
        <source>Hints for the first start</source>
        <translation>Hinweise zum ersten Start</translation>
    </message>
    <message>
        <source>Close hints</source>
        <translation>Hinweise schließen</translation>
    </message>
    <message>
        <source>Close the hints (Esc)</source>
        <translation>Die Hinweise schließen (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Got It</source>
        <translation>Verstanden</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>chiaro::app::FrameTextures</name>
    <message>
        <source>Sketching the view</source>
        <translation>Ansicht wird skizziert</translation>
    </message>
    <message>
        <source>Synthesising the view</source>
        <translation>Ansicht wird synthetisiert</translation>
    </message>
</context>
<context>
    <name>chiaro::app::GradientDock</name>
    <message>
        <source>Gradient Curve</source>
        <translation>Verlaufskurve</translation>
    </message>
</context>
<context>
    <name>chiaro::app::HeatMaps</name>
    <message>
        <source>&amp;Live Metrics</source>
        <translation>&amp;Laufende Messung</translation>
    </message>
    <message>
        <source>Measure what the viewport shows whenever it comes to rest</source>
        <translation>Die Ansicht messen, sobald sie zur Ruhe kommt</translation>
    </message>
    <message>
        <source>Similarity &amp;Heat Map</source>
        <translation>&amp;Heatmap der Ähnlichkeit</translation>
    </message>
    <message>
        <source>Show in the viewport how little each pixel resembles the strip</source>
        <translation>In der Ansicht zeigen, wie wenig jedes Pixel dem Streifen ähnelt</translation>
    </message>
    <message>
        <source>Sha&amp;ding Heat Map</source>
        <translation>Hea&amp;tmap der Schattierung</translation>
    </message>
    <message>
        <source>Show in the viewport how far each pixel&apos;s shade is from its light</source>
        <translation>In der Ansicht zeigen, wie weit der Ton jedes Pixels von seinem Licht abweicht</translation>
    </message>
    <message>
        <source>refining…</source>
        <translation>wird verfeinert …</translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation>wird gemessen …</translation>
    </message>
    <message>
        <source>similarity %1</source>
        <translation>Ähnlichkeit %1</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>shading %1</source>
        <translation>Schattierung %1</translation>
    </message>
</context>
<context>
    <name>chiaro::app::HelpMenu</name>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;About Chiaro</source>
        <translation>Ü&amp;ber Chiaro</translation>
    </message>
    <message>
        <source>About Chiaro</source>
        <translation>Über Chiaro</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Chiaro %1&lt;/h3&gt;&lt;p&gt;Shades 3D meshes with an artist&apos;s own paint.&lt;/p&gt;&lt;p&gt;After Kulla, Tucek, Bailey and Grimm, &lt;i&gt;Using Texture Synthesis for Non-Photorealistic Shading from Paint Samples&lt;/i&gt;, WUCSE-2003-54.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Chiaro %1&lt;/h3&gt;&lt;p&gt;Schattiert 3D-Netze mit der eigenen Farbe der Künstlerin, des Künstlers.&lt;/p&gt;&lt;p&gt;Nach Kulla, Tucek, Bailey und Grimm, &lt;i&gt;Using Texture Synthesis for Non-Photorealistic Shading from Paint Samples&lt;/i&gt;, WUCSE-2003-54.&lt;/p&gt;&lt;p&gt;GPL-3.0-or-later&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&amp;First Steps</source>
        <translation>&amp;Erste Schritte</translation>
    </message>
    <message>
        <source>Help for This &amp;Dock</source>
        <translation>Hilfe zu diesem &amp;Dock</translation>
    </message>
</context>
<context>
    <name>chiaro::app::HelpWindow</name>
    <message>
        <source>First Steps</source>
        <translation>Erste Schritte</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Gradient Curve</source>
        <translation>Verlaufskurve</translation>
    </message>
    <message>
        <source>View Planning</source>
        <translation>Ansichtsplanung</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>Metric Graph</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>Chiaro Help</source>
        <translation>Chiaro-Hilfe</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Inhalt</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>Comparing Methods</source>
        <translation>Verfahren vergleichen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::HistoryDock</name>
    <message>
        <source>History</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>As it was opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>A click goes back or forth to an edit; the disk marks what is saved</source>
        <translation>Ein Klick geht zu einer Bearbeitung vor oder zurück; die Diskette zeigt, was gespeichert ist</translation>
    </message>
</context>
<context>
    <name>chiaro::app::JobModel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>%1
Delete cancels it</source>
        <translation>%1
Entf bricht ab</translation>
    </message>
</context>
<context>
    <name>chiaro::app::JobRunner</name>
    <message>
        <source>%1: there is not enough memory; choose a smaller size</source>
        <translation>%1: Der Speicher reicht nicht; bitte eine kleinere Größe wählen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::JobStatus</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel what is running</source>
        <translation>Abbrechen, was läuft</translation>
    </message>
    <message>
        <source> (%1 more)</source>
        <translation> (%1 weitere)</translation>
    </message>
</context>
<context>
    <name>chiaro::app::JobsDock</name>
    <message>
        <source>Jobs</source>
        <translation>Aufträge</translation>
    </message>
    <message>
        <source>Cancel job</source>
        <translation>Auftrag abbrechen</translation>
    </message>
    <message>
        <source>Cancel the selected job (Delete)</source>
        <translation>Gewählten Auftrag abbrechen (Entf)</translation>
    </message>
    <message>
        <source>Cancel all</source>
        <translation>Alle abbrechen</translation>
    </message>
    <message>
        <source>Cancel everything that runs</source>
        <translation>Alles abbrechen, was läuft</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Clear the list of what ended</source>
        <translation>Liste der beendeten Aufträge leeren</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Language</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Chiaro speaks it from its next start on.</source>
        <translation>Chiaro spricht sie ab dem nächsten Start.</translation>
    </message>
    <message>
        <source>As the &amp;System</source>
        <translation>Wie das &amp;System</translation>
    </message>
</context>
<context>
    <name>chiaro::app::LightPanel</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Where the light stands</source>
        <translation>Wo das Licht steht</translation>
    </message>
    <message>
        <source>From the scene towards the light; only the direction counts</source>
        <translation>Von der Szene zum Licht; nur die Richtung zählt</translation>
    </message>
    <message>
        <source>Change Light</source>
        <translation>Licht ändern</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MainWindow</name>
    <message>
        <source>The figures are at %1</source>
        <translation>Die Zahlen liegen unter %1</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>The method shown, and how long its last frame took</source>
        <translation>Das gezeigte Verfahren und die Dauer seines letzten Bildes</translation>
    </message>
    <message>
        <source>%1 · %2 ms</source>
        <translation>%1 · %2 ms</translation>
    </message>
    <message>
        <source>%1[*] — Chiaro</source>
        <translation>%1[*] — Chiaro</translation>
    </message>
    <message>
        <source>%1 (read-only)</source>
        <translation>%1 (schreibgeschützt)</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MeshExportDialog</name>
    <message>
        <source>Export Mesh</source>
        <translation>Netz exportieren</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wählen …</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>Meshes (*.glb *.obj *.ply)</source>
        <translation>Netze (*.glb *.obj *.ply)</translation>
    </message>
    <message>
        <source>GLB (glTF)</source>
        <translation>GLB (glTF)</translation>
    </message>
    <message>
        <source>One file with mesh and paint, for Blender, game engines and the web.</source>
        <translation>Eine Datei mit Netz und Farbe, für Blender, Spiele-Engines und das Web.</translation>
    </message>
    <message>
        <source>OBJ with a picture</source>
        <translation>OBJ mit Bild</translation>
    </message>
    <message>
        <source>Three files: mesh, material and picture. Every program reads them.</source>
        <translation>Drei Dateien: Netz, Material und Bild. Jedes Programm liest sie.</translation>
    </message>
    <message>
        <source>PLY with vertex colours</source>
        <translation>PLY mit Eckpunktfarben</translation>
    </message>
    <message>
        <source>No picture: strokes show only on meshes whose faces are smaller than they are.</source>
        <translation>Ohne Bild: Striche sieht man nur auf Netzen, deren Flächen kleiner sind als sie.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Meshes</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MethodComparison</name>
    <message>
        <source>The project was edited while it was measured: measure again</source>
        <translation>Das Projekt wurde während der Messung geändert: bitte erneut messen</translation>
    </message>
    <message>
        <source>Comparing the methods</source>
        <translation>Verfahren werden verglichen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MethodSwitch</name>
    <message>
        <source>The paint is laid right into the picture, each piece where it is as light as the object: the best-looking single pictures</source>
        <translation>Die Farbe wird direkt ins Bild gelegt, jedes Stück dort, wo es so hell ist wie das Objekt: die schönsten Einzelbilder</translation>
    </message>
    <message>
        <source>Strokes that face the viewer, from a 3D texture: every frame in real time</source>
        <translation>Striche, die zum Betrachter zeigen, aus einer 3D-Textur: jedes Bild in Echtzeit</translation>
    </message>
    <message>
        <source>Strokes that stay on the object, painted from many sides: made once, then every frame in real time</source>
        <translation>Striche, die auf dem Objekt bleiben, von vielen Seiten gemalt: einmal erzeugt, dann jedes Bild in Echtzeit</translation>
    </message>
    <message>
        <source>%1 (%2)
%3</source>
        <translation>%1 (%2)
%3</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MetricGraphDock</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>Metric Graph</source>
        <translation>Messwerte</translation>
    </message>
    <message>
        <source>Viewport</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>Similarity error</source>
        <translation>Ähnlichkeitsfehler</translation>
    </message>
    <message>
        <source>Shading error</source>
        <translation>Schattierungsfehler</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Errors of the methods</source>
        <translation>Fehler der Verfahren</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>Distortions</source>
        <translation>Verzerrungen</translation>
    </message>
    <message>
        <source>Export figures</source>
        <translation>Zahlen exportieren</translation>
    </message>
    <message>
        <source>Write what this tab shows as CSV, Markdown, SVG or PNG</source>
        <translation>Den Inhalt dieses Reiters als CSV, Markdown, SVG oder PNG schreiben</translation>
    </message>
    <message>
        <source>…</source>
        <translation>…</translation>
    </message>
    <message>
        <source>–</source>
        <translation>–</translation>
    </message>
    <message>
        <source>How little the picture resembles its strips, at pixels drawn by chance; smaller is better</source>
        <translation>Wie wenig das Bild seinen Streifen ähnelt, an zufälligen Pixeln; kleiner ist besser</translation>
    </message>
    <message>
        <source>How far the shade that the texture is meant for is from the light, 0 to 1; smaller is better</source>
        <translation>Wie weit der Ton, für den die Textur gedacht ist, vom Licht abweicht, 0 bis 1; kleiner ist besser</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Needs a mesh and a strip of paint</source>
        <translation>Braucht ein Netz und einen Farbstreifen</translation>
    </message>
    <message>
        <source>The project has changed since: these figures are of before</source>
        <translation>Das Projekt hat sich seither geändert: Die Zahlen sind von vorher</translation>
    </message>
    <message>
        <source>Charts (*.svg *.png);;Table (*.csv)</source>
        <translation>Diagramme (*.svg *.png);;Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Table (*.csv);;Markdown (*.md)</source>
        <translation>Tabelle (*.csv);;Markdown (*.md)</translation>
    </message>
    <message>
        <source>Export Figures</source>
        <translation>Zahlen exportieren</translation>
    </message>
    <message>
        <source>Exporting %1</source>
        <translation>%1 wird exportiert</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MetricTools</name>
    <message>
        <source>The viewport&apos;s errors: how little it resembles its strips, and how far its shades are from the light</source>
        <translation>Die Fehler der Ansicht: wie wenig sie ihren Streifen ähnelt und wie weit ihre Töne vom Licht abweichen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::MissingFilesDialog</name>
    <message>
        <source>Missing Files</source>
        <translation>Fehlende Dateien</translation>
    </message>
    <message>
        <source>Missing files</source>
        <translation>Fehlende Dateien</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Used as</source>
        <translation>Verwendet als</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Find…</source>
        <translation>Suchen …</translation>
    </message>
    <message>
        <source>Open Without Them</source>
        <translation>Ohne sie öffnen</translation>
    </message>
    <message>
        <source>sample %1</source>
        <translation>Probe %1</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>Netz</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>%1 (%1);;All files (*)</source>
        <translation>%1 (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>%1 suchen</translation>
    </message>
    <message>
        <source>These files of the project are not where they were. Find one, and those beside it are found as well; or search a folder for all of them.</source>
        <translation>Diese Dateien des Projekts sind nicht mehr, wo sie waren. Wird eine gefunden, so auch die daneben; oder einen Ordner nach allen durchsuchen.</translation>
    </message>
    <message>
        <source>Search Folder…</source>
        <translation>Ordner durchsuchen …</translation>
    </message>
    <message>
        <source>Looks for all of them in a folder and those below</source>
        <translation>Sucht alle in einem Ordner und denen darunter</translation>
    </message>
    <message>
        <source>All of them were found.</source>
        <translation>Alle wurden gefunden.</translation>
    </message>
    <message>
        <source>%1 of %2 were found.</source>
        <translation>%1 von %2 wurden gefunden.</translation>
    </message>
    <message>
        <source>None of them is there.</source>
        <translation>Keine davon ist dort.</translation>
    </message>
    <message>
        <source>Search Folder</source>
        <translation>Ordner durchsuchen</translation>
    </message>
    <message>
        <source>Looking in %1…</source>
        <translation>%1 wird durchsucht …</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ObjectPanel</name>
    <message>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>The paint that the selected objects wear</source>
        <translation>Die Farbe, die die gewählten Objekte tragen</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skalierung</translation>
    </message>
    <message>
        <source>Move Object</source>
        <translation>Objekt verschieben</translation>
    </message>
    <message>
        <source>Turn Object</source>
        <translation>Objekt drehen</translation>
    </message>
    <message>
        <source>Scale Object</source>
        <translation>Objekt skalieren</translation>
    </message>
    <message>
        <source>Assign Sample</source>
        <translation>Probe zuweisen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ObjectTextures</name>
    <message>
        <source>Sketching %1</source>
        <translation>%1 wird skizziert</translation>
    </message>
    <message>
        <source>Painting %1</source>
        <translation>%1 wird bemalt</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Opener</name>
    <message>
        <source>The added mesh is %1 times as large as the rest; its Scale in the Scene dock fits it in.</source>
        <translation>Das hinzugefügte Netz ist %1-mal so groß wie der Rest; seine Skalierung im Dock Szene passt es an.</translation>
    </message>
    <message>
        <source>The rest is %1 times as large as the added mesh; its Scale in the Scene dock fits it in.</source>
        <translation>Der Rest ist %1-mal so groß wie das hinzugefügte Netz; seine Skalierung im Dock Szene passt es an.</translation>
    </message>
    <message>
        <source>Opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>%1 was written by a newer Chiaro (format %2, this one writes %3) and is open read-only; Save As makes a copy without what only the newer one knows.</source>
        <translation>%1 wurde von einem neueren Chiaro geschrieben (Format %2, dieses schreibt %3) und ist schreibgeschützt geöffnet; Speichern unter macht eine Kopie ohne das, was nur das neuere kennt.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Paints</name>
    <message>
        <source>Reading %1</source>
        <translation>%1 wird gelesen</translation>
    </message>
    <message>
        <source>Separating %1</source>
        <translation>%1 wird zerlegt</translation>
    </message>
    <message>
        <source>Synthesising %1</source>
        <translation>%1 wird synthetisiert</translation>
    </message>
    <message>
        <source>Sketching %1</source>
        <translation>%1 wird skizziert</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ParametersDock</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Synthesis</source>
        <translation>Synthese</translation>
    </message>
    <message>
        <source>Quilting</source>
        <translation>Quilting</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Kohärenz</translation>
    </message>
    <message>
        <source>For animations; the picture here stays as it is.</source>
        <translation>Für Animationen; das Bild hier bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>Striche</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Blending</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Playback</name>
    <message>
        <source>Key Light</source>
        <translation>Licht-Schlüsselbild</translation>
    </message>
</context>
<context>
    <name>chiaro::app::PresetMenu</name>
    <message>
        <source>Presets</source>
        <translation>Vorlagen</translation>
    </message>
    <message>
        <source>Presets: apply, save, rename, remove</source>
        <translation>Vorlagen: anwenden, speichern, umbenennen, entfernen</translation>
    </message>
    <message>
        <source>No presets yet</source>
        <translation>Noch keine Vorlagen</translation>
    </message>
    <message>
        <source>&amp;Save Preset…</source>
        <translation>Vorlage &amp;speichern …</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>Ent&amp;fernen</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>&amp;Ordner öffnen</translation>
    </message>
    <message>
        <source>Presets are shared by copying the files that are there</source>
        <translation>Vorlagen gibt man weiter, indem man die Dateien dort kopiert</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>Vorlage speichern</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Rename Preset</source>
        <translation>Vorlage umbenennen</translation>
    </message>
    <message>
        <source>Remove Preset</source>
        <translation>Vorlage entfernen</translation>
    </message>
    <message>
        <source>Remove the preset %1? Its file is deleted.</source>
        <translation>Die Vorlage %1 entfernen? Ihre Datei wird gelöscht.</translation>
    </message>
    <message>
        <source>%1: can&apos;t be shown; open it in a file manager</source>
        <translation>%1: lässt sich nicht zeigen; bitte in einem Dateimanager öffnen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ProjectCollector</name>
    <message>
        <source>Collect Files: Choose a Folder</source>
        <translation>Dateien sammeln: Ordner wählen</translation>
    </message>
    <message>
        <source>Looking for the project&apos;s files</source>
        <translation>Dateien des Projekts werden gesucht</translation>
    </message>
    <message>
        <source>Collect Files</source>
        <translation>Dateien sammeln</translation>
    </message>
    <message>
        <source>Collecting files</source>
        <translation>Dateien werden gesammelt</translation>
    </message>
    <message>
        <source>Everything is at %1</source>
        <translation>Alles liegt unter %1</translation>
    </message>
    <message>
        <source>The project is at %1, without what is missing: %2</source>
        <translation>Das Projekt liegt unter %1, ohne das Fehlende: %2</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ProjectFiles</name>
    <message>
        <source>Chiaro projects (*.chiaro)</source>
        <translation>Chiaro-Projekte (*.chiaro)</translation>
    </message>
    <message>
        <source>Strips (*.png *.tif *.tiff *.jpg *.jpeg *.exr *.webp)</source>
        <translation>Streifen (*.png *.tif *.tiff *.jpg *.jpeg *.exr *.webp)</translation>
    </message>
    <message>
        <source>Meshes (*.obj *.ply *.off *.stl *.glb *.gltf)</source>
        <translation>Netze (*.obj *.ply *.off *.stl *.glb *.gltf)</translation>
    </message>
    <message>
        <source>Open Project</source>
        <translation>Projekt öffnen</translation>
    </message>
    <message>
        <source>Open Strip</source>
        <translation>Streifen öffnen</translation>
    </message>
    <message>
        <source>Open Mesh</source>
        <translation>Netz öffnen</translation>
    </message>
    <message>
        <source>Add Mesh</source>
        <translation>Netz hinzufügen</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Projekt speichern</translation>
    </message>
    <message>
        <source>Unsaved Changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 Kopie</translation>
    </message>
    <message>
        <source>%1 is a copy in this Chiaro&apos;s format; what only the newer one knows is not in it.</source>
        <translation>%1 ist eine Kopie im Format dieses Chiaro; was nur das neuere kennt, ist nicht darin.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::RecentFiles</name>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Zuletzt &amp;geöffnet</translation>
    </message>
</context>
<context>
    <name>chiaro::app::RecoveryDialog</name>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Chiaro ended before these changes were saved. Recover them?</source>
        <translation>Chiaro endete, bevor diese Änderungen gespeichert waren. Wiederherstellen?</translation>
    </message>
    <message>
        <source>Changes that were kept</source>
        <translation>Aufbewahrte Änderungen</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>It was never saved</source>
        <translation>Es wurde nie gespeichert</translation>
    </message>
    <message>
        <source>Not Now</source>
        <translation>Jetzt nicht</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Removes these changes for good</source>
        <translation>Entfernt diese Änderungen endgültig</translation>
    </message>
</context>
<context>
    <name>chiaro::app::RenderMenu</name>
    <message>
        <source>&amp;Render</source>
        <translation>&amp;Rendern</translation>
    </message>
    <message>
        <source>Render &amp;Animation…</source>
        <translation>&amp;Animation rendern …</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ReplaceQuestion</name>
    <message>
        <source>%1 are there already. Replace them?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>%1 and %2 more are there already. Replace them?</source>
        <translation>%1 und %2 weitere gibt es schon. Ersetzen?</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SafeMode</name>
    <message>
        <source>Safe mode</source>
        <translation>Sicherer Modus</translation>
    </message>
    <message>
        <source>Started with --safe: without OpenGL, in the usual layout, and nothing is remembered.</source>
        <translation>Mit --safe gestartet: ohne OpenGL, in der üblichen Anordnung, und nichts wird gemerkt.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::Safekeeping</name>
    <message>
        <source>Changes are kept every minute or 25 edits, in case Chiaro ends before they are saved</source>
        <translation>Änderungen werden jede Minute oder alle 25 Bearbeitungen aufbewahrt, falls Chiaro vor dem Speichern endet</translation>
    </message>
    <message>
        <source>Autosaved %1</source>
        <translation>Gesichert %1</translation>
    </message>
    <message>
        <source>Autosave failed</source>
        <translation>Sicherung misslungen</translation>
    </message>
    <message>
        <source>Open Twice</source>
        <translation>Doppelt geöffnet</translation>
    </message>
    <message>
        <source>%1 is open in another Chiaro (%2). Who saves last wins: what the other saves is lost.</source>
        <translation>%1 ist in einem anderen Chiaro geöffnet (%2). Wer zuletzt speichert, gewinnt: Was der andere speichert, geht verloren.</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SampleDock</name>
    <message>
        <source>Sample</source>
        <translation>Probe</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Proben</translation>
    </message>
    <message>
        <source>Add sample</source>
        <translation>Probe hinzufügen</translation>
    </message>
    <message>
        <source>Open a strip as a new sample</source>
        <translation>Einen Streifen als neue Probe öffnen</translation>
    </message>
    <message>
        <source>Remove sample</source>
        <translation>Probe entfernen</translation>
    </message>
    <message>
        <source>Remove the selected sample</source>
        <translation>Gewählte Probe entfernen</translation>
    </message>
    <message>
        <source>Paint everything</source>
        <translation>Alles bemalen</translation>
    </message>
    <message>
        <source>Put this sample on all objects</source>
        <translation>Diese Probe auf alle Objekte legen</translation>
    </message>
    <message>
        <source>Double-click or F2 renames a sample; scans can be dropped here</source>
        <translation>Doppelklick oder F2 benennt eine Probe um; Scans kann man hierher ziehen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SampleMenu</name>
    <message>
        <source>&amp;Sample</source>
        <translation>&amp;Probe</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>Nach &amp;links drehen</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>Nach &amp;rechts drehen</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>&amp;Spiegeln</translation>
    </message>
    <message>
        <source>&amp;Whole Scan</source>
        <translation>&amp;Ganzer Scan</translation>
    </message>
    <message>
        <source>&amp;Paint Everything</source>
        <translation>&amp;Alles bemalen</translation>
    </message>
    <message>
        <source>&amp;Synthesise Again</source>
        <translation>&amp;Erneut synthetisieren</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SceneDock</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Select an object or a light.</source>
        <translation>Ein Objekt oder ein Licht wählen.</translation>
    </message>
    <message>
        <source>Objects and lights</source>
        <translation>Objekte und Lichter</translation>
    </message>
    <message>
        <source>Add mesh</source>
        <translation>Netz hinzufügen</translation>
    </message>
    <message>
        <source>Add the objects of a mesh file</source>
        <translation>Die Objekte einer Netzdatei hinzufügen</translation>
    </message>
    <message>
        <source>Add light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation>Ein Licht hinzufügen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Put copies of the selected objects in the scene (Ctrl+D)</source>
        <translation>Kopien der gewählten Objekte in die Szene setzen (Strg+D)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove what is selected (Delete)</source>
        <translation>Ausgewähltes entfernen (Entf)</translation>
    </message>
    <message>
        <source>Shadows and Occlusion</source>
        <translation>Schatten und Verdeckung</translation>
    </message>
    <message>
        <source>Off is fastest: with shadows or ambient occlusion the CPU draws the viewport, a coarse picture first.</source>
        <translation>Aus ist am schnellsten: Mit Schatten oder Umgebungsverdeckung zeichnet die CPU die Ansicht, zuerst ein grobes Bild.</translation>
    </message>
    <message>
        <source>Add &amp;Light</source>
        <translation>&amp;Licht hinzufügen</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Duplizieren</translation>
    </message>
    <message>
        <source>&amp;Hide or Show</source>
        <translation>&amp;Aus- oder einblenden</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>Add Light</source>
        <translation>Licht hinzufügen</translation>
    </message>
    <message>
        <source>Remove Light</source>
        <translation>Licht entfernen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SceneMenu</name>
    <message>
        <source>S&amp;cene</source>
        <translation>S&amp;zene</translation>
    </message>
    <message>
        <source>&amp;Add Mesh…</source>
        <translation>&amp;Netz hinzufügen …</translation>
    </message>
</context>
<context>
    <name>chiaro::app::SceneModel</name>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Light %1</source>
        <translation>Licht %1</translation>
    </message>
    <message>
        <source>Hide (H)</source>
        <translation>Ausblenden (H)</translation>
    </message>
    <message>
        <source>Show (H)</source>
        <translation>Einblenden (H)</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>sichtbar</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>A light; F2 renames it</source>
        <translation>Ein Licht; F2 benennt es um</translation>
    </message>
    <message>
        <source>An object; F2 renames it</source>
        <translation>Ein Objekt; F2 benennt es um</translation>
    </message>
    <message>
        <source>Rename Light</source>
        <translation>Licht umbenennen</translation>
    </message>
    <message>
        <source>Rename Object</source>
        <translation>Objekt umbenennen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Einblenden</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
</context>
<context>
    <name>chiaro::app::StudyPane</name>
    <message>
        <source>Measure to see how the similarity error answers when a texture is turned, scaled or torn: three built-in textures, and the current strip.</source>
        <translation>Messen zeigt, wie der Ähnlichkeitsfehler antwortet, wenn eine Textur gedreht, skaliert oder zerrissen wird: drei eingebaute Texturen und der aktuelle Streifen.</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Scale in x</source>
        <translation>Skalierung in x</translation>
    </message>
    <message>
        <source>Scale in y</source>
        <translation>Skalierung in y</translation>
    </message>
    <message>
        <source>Scale in x and y</source>
        <translation>Skalierung in x und y</translation>
    </message>
    <message>
        <source>Discontinuity</source>
        <translation>Unterbrechung</translation>
    </message>
    <message>
        <source>Distortion</source>
        <translation>Verzerrung</translation>
    </message>
    <message>
        <source>How the textures are distorted</source>
        <translation>Wie die Texturen verzerrt werden</translation>
    </message>
    <message>
        <source>Blocks of</source>
        <translation>Blöcke von</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Gedreht um</translation>
    </message>
    <message>
        <source>Scaled by</source>
        <translation>Skaliert um</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Of an earlier strip: measure again</source>
        <translation>Von einem früheren Streifen: bitte erneut messen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ThemeSwitch</name>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>As the &amp;System</source>
        <translation>Wie das &amp;System</translation>
    </message>
</context>
<context>
    <name>chiaro::app::TimelineDock</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Go to the first frame that is rendered</source>
        <translation>Zum ersten gerenderten Bild</translation>
    </message>
    <message>
        <source>Previous key</source>
        <translation>Voriges Schlüsselbild</translation>
    </message>
    <message>
        <source>Go to the key before (Down)</source>
        <translation>Zum vorigen Schlüsselbild (Ab)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play the frames that are rendered (Ctrl+Space)</source>
        <translation>Die gerenderten Bilder abspielen (Strg+Leertaste)</translation>
    </message>
    <message>
        <source>Next key</source>
        <translation>Nächstes Schlüsselbild</translation>
    </message>
    <message>
        <source>Go to the next key (Up)</source>
        <translation>Zum nächsten Schlüsselbild (Auf)</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>Go to the last frame that is rendered</source>
        <translation>Zum letzten gerenderten Bild</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Current frame</source>
        <translation>Aktuelles Bild</translation>
    </message>
    <message>
        <source>The frame that is shown</source>
        <translation>Das gezeigte Bild</translation>
    </message>
    <message>
        <source>of</source>
        <translation>von</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How many frames there are; turns go around once in them</source>
        <translation>Wie viele Bilder es gibt; Drehungen gehen darin einmal herum</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>How fast they play, 1..240</source>
        <translation>Wie schnell sie laufen, 1 bis 240</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> B/s</translation>
    </message>
    <message>
        <source>How many pictures a second were really shown</source>
        <translation>Wie viele Bilder pro Sekunde wirklich gezeigt wurden</translation>
    </message>
    <message>
        <source>Key camera</source>
        <translation>Kamera setzen</translation>
    </message>
    <message>
        <source>Key the camera as it is shown now (K)</source>
        <translation>Schlüsselbild der Kamera, wie sie jetzt steht (K)</translation>
    </message>
    <message>
        <source>Key light</source>
        <translation>Licht setzen</translation>
    </message>
    <message>
        <source>Key the first light as it is shown now (Shift+K)</source>
        <translation>Schlüsselbild des ersten Lichts, wie es jetzt steht (Umschalt+K)</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
    <message>
        <source>Remove the selected key (Delete)</source>
        <translation>Gewähltes Schlüsselbild entfernen (Entf)</translation>
    </message>
    <message>
        <source>Turntable</source>
        <translation>Drehteller</translation>
    </message>
    <message>
        <source>The camera goes around once over all frames</source>
        <translation>Die Kamera geht über alle Bilder einmal herum</translation>
    </message>
    <message>
        <source>Light sweep</source>
        <translation>Lichtlauf</translation>
    </message>
    <message>
        <source>The lights go around once over all frames</source>
        <translation>Die Lichter gehen über alle Bilder einmal herum</translation>
    </message>
    <message>
        <source>Between keys</source>
        <translation>Zwischen Schlüsselbildern</translation>
    </message>
    <message>
        <source>How things move from key to key</source>
        <translation>Wie sich Dinge von Schlüsselbild zu Schlüsselbild bewegen</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Render</source>
        <translation>Rendern</translation>
    </message>
    <message>
        <source>First frame to render</source>
        <translation>Erstes zu renderndes Bild</translation>
    </message>
    <message>
        <source>The first frame that is rendered</source>
        <translation>Das erste gerenderte Bild</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Last frame to render</source>
        <translation>Letztes zu renderndes Bild</translation>
    </message>
    <message>
        <source>The last frame that is rendered</source>
        <translation>Das letzte gerenderte Bild</translation>
    </message>
    <message>
        <source>Light Sweep</source>
        <translation>Lichtlauf</translation>
    </message>
    <message>
        <source>Change Interpolation</source>
        <translation>Interpolation ändern</translation>
    </message>
    <message>
        <source>Change Frames</source>
        <translation>Bilder ändern</translation>
    </message>
    <message>
        <source>Change Frame Rate</source>
        <translation>Bildrate ändern</translation>
    </message>
    <message>
        <source>Change Render Range</source>
        <translation>Renderbereich ändern</translation>
    </message>
    <message>
        <source>Move Key</source>
        <translation>Schlüsselbild verschieben</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>shown: %1 fps</source>
        <translation>gezeigt: %1 B/s</translation>
    </message>
    <message>
        <source>&amp;Play or Pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Key &amp;Camera</source>
        <translation>&amp;Kamera setzen</translation>
    </message>
    <message>
        <source>Key &amp;Light</source>
        <translation>&amp;Licht setzen</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Key Camera</source>
        <translation>Kamera-Schlüsselbild</translation>
    </message>
    <message>
        <source>Key Light</source>
        <translation>Licht-Schlüsselbild</translation>
    </message>
    <message>
        <source>Remove Key</source>
        <translation>Schlüsselbild entfernen</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewList</name>
    <message>
        <source>View %1, placed</source>
        <translation>Ansicht %1, gesetzt</translation>
    </message>
    <message>
        <source>View %1, planned</source>
        <translation>Ansicht %1, geplant</translation>
    </message>
    <message>
        <source> · to be planned</source>
        <translation> · noch zu planen</translation>
    </message>
    <message>
        <source> · pass %1</source>
        <translation> · Durchgang %1</translation>
    </message>
    <message>
        <source> · sees no face</source>
        <translation> · sieht keine Fläche</translation>
    </message>
    <message>
        <source> · 1 face</source>
        <translation> · 1 Fläche</translation>
    </message>
    <message>
        <source> · %L1 faces</source>
        <translation> · %L1 Flächen</translation>
    </message>
    <message>
        <source>
%1 of the area, at %2° on average</source>
        <translation>
%1 der Oberfläche, im Mittel unter %2°</translation>
    </message>
    <message>
        <source>Shares no face with another view</source>
        <translation>Teilt keine Fläche mit einer anderen Ansicht</translation>
    </message>
    <message>
        <source>%1 with view %2</source>
        <translation>%1 mit Ansicht %2</translation>
    </message>
    <message>
        <source>Shares %1, less with %2 more</source>
        <translation>Teilt %1, weniger mit %2 weiteren</translation>
    </message>
    <message>
        <source>Shares %1</source>
        <translation>Teilt %1</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewMeasures</name>
    <message>
        <source>Measuring the view</source>
        <translation>Ansicht wird gemessen</translation>
    </message>
    <message>
        <source>Measuring every pixel</source>
        <translation>Jedes Pixel wird gemessen</translation>
    </message>
    <message>
        <source>Similarity error</source>
        <translation>Ähnlichkeitsfehler</translation>
    </message>
    <message>
        <source>Shading error</source>
        <translation>Schattierungsfehler</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewMenu</name>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Frame All</source>
        <translation>Alles &amp;zeigen</translation>
    </message>
    <message>
        <source>&amp;Reset Layout</source>
        <translation>Anordnung zu&amp;rücksetzen</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farbschema</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>S&amp;prache</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>&amp;Blender</source>
        <translation>&amp;Blender</translation>
    </message>
    <message>
        <source>&amp;Maya, Painter</source>
        <translation>&amp;Maya, Painter</translation>
    </message>
    <message>
        <source>&amp;Trackpad</source>
        <translation>&amp;Trackpad</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewOverlays</name>
    <message>
        <source>&amp;View Frames</source>
        <translation>&amp;Sichtfelder</translation>
    </message>
    <message>
        <source>Show in the viewport where the object&apos;s views are</source>
        <translation>In der Ansicht zeigen, wo die Ansichten des Objekts stehen</translation>
    </message>
    <message>
        <source>&amp;Uncovered Faces</source>
        <translation>&amp;Unbedeckte Flächen</translation>
    </message>
    <message>
        <source>Show in the viewport which faces the first pass leaves, through what hides them</source>
        <translation>In der Ansicht zeigen, welche Flächen der erste Durchgang auslässt, durch alles hindurch</translation>
    </message>
    <message>
        <source>Face &amp;Groups</source>
        <translation>Flächen&amp;gruppen</translation>
    </message>
    <message>
        <source>Show in the viewport which view each face belongs to, by its colour</source>
        <translation>In der Ansicht durch Farben zeigen, zu welcher Ansicht jede Fläche gehört</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewPlanningDock</name>
    <message>
        <source>View Planning</source>
        <translation>Ansichtsplanung</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Whose views these are</source>
        <translation>Wessen Ansichten dies sind</translation>
    </message>
    <message>
        <source>Add from camera</source>
        <translation>Von der Kamera hinzufügen</translation>
    </message>
    <message>
        <source>Place a view where the viewport looks from (the cross)</source>
        <translation>Eine Ansicht dort setzen, von wo die Kamera blickt (das Kreuz)</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Festhalten</translation>
    </message>
    <message>
        <source>Keep the selected view as it is (Return)</source>
        <translation>Die gewählte Ansicht so behalten (Eingabetaste)</translation>
    </message>
    <message>
        <source>Remove view</source>
        <translation>Ansicht entfernen</translation>
    </message>
    <message>
        <source>Remove the placed view (Delete)</source>
        <translation>Gesetzte Ansicht entfernen (Entf)</translation>
    </message>
    <message>
        <source>Plan again</source>
        <translation>Erneut planen</translation>
    </message>
    <message>
        <source>Plan again what was cancelled; placed views stay</source>
        <translation>Abgebrochenes erneut planen; gesetzte Ansichten bleiben</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>Select a view to read about it.</source>
        <translation>Eine Ansicht wählen, um über sie zu lesen.</translation>
    </message>
    <message>
        <source>No mesh</source>
        <translation>Kein Netz</translation>
    </message>
    <message>
        <source>1 view</source>
        <translation>1 Ansicht</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 Ansichten</translation>
    </message>
    <message>
        <source>Planning…</source>
        <translation>Wird geplant …</translation>
    </message>
    <message>
        <source>Not planned</source>
        <translation>Nicht geplant</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewPlans</name>
    <message>
        <source>Planning views of %1</source>
        <translation>Ansichten von %1 werden geplant</translation>
    </message>
</context>
<context>
    <name>chiaro::app::ViewThumbnails</name>
    <message>
        <source>Drawing views</source>
        <translation>Ansichten werden gezeichnet</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::ColorPathBar</name>
    <message>
        <source>Colour stops</source>
        <translation>Farbstopps</translation>
    </message>
    <message>
        <source>Ctrl+click adds a stop, a drag moves it, a double click changes its colour, Delete removes it.
Page Up and Page Down select a stop, Left and Right nudge it (Shift: more), Enter changes its colour, Insert adds one.
Ctrl+C and Ctrl+V copy and paste the stops as text, such as 0 #201040, 1 #fff0b0.</source>
        <translation>Strg+Klick fügt einen Stopp hinzu, Ziehen verschiebt ihn, ein Doppelklick ändert seine Farbe, Entf entfernt ihn.
Bild auf und Bild ab wählen einen Stopp, Links und Rechts rücken ihn (Umschalt: weiter), die Eingabetaste ändert seine Farbe, Einfg fügt einen hinzu.
Strg+C und Strg+V kopieren die Stopps und fügen sie ein, als Text wie 0 #201040, 1 #fff0b0.</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::ColorPathView</name>
    <message>
        <source>Recolour</source>
        <translation>Umfärben</translation>
    </message>
    <message>
        <source>Off: the sample&apos;s own colours</source>
        <translation>Aus: die eigenen Farben der Probe</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Change the selected stop&apos;s colour (Enter)</source>
        <translation>Farbe des gewählten Stopps ändern (Eingabetaste)</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>The selected stop&apos;s place, 0 dark to 1 light</source>
        <translation>Ort des gewählten Stopps, 0 dunkel bis 1 hell</translation>
    </message>
    <message>
        <source>Add stop</source>
        <translation>Stopp hinzufügen</translation>
    </message>
    <message>
        <source>Add a stop (Ctrl+click on the bar, or Insert)</source>
        <translation>Stopp hinzufügen (Strg+Klick auf den Balken oder Einfg)</translation>
    </message>
    <message>
        <source>Remove stop</source>
        <translation>Stopp entfernen</translation>
    </message>
    <message>
        <source>Remove the selected stop (Delete)</source>
        <translation>Gewählten Stopp entfernen (Entf)</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>Swap the dark and the light end</source>
        <translation>Dunkles und helles Ende vertauschen</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>Verteilen</translation>
    </message>
    <message>
        <source>Space the stops evenly</source>
        <translation>Stopps gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolation</translation>
    </message>
    <message>
        <source>How colours between stops are mixed: as the report does, or evenly to the eye</source>
        <translation>Wie Farben zwischen Stopps gemischt werden: wie im Bericht oder gleichmäßig fürs Auge</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Oklab</source>
        <translation>Oklab</translation>
    </message>
    <message>
        <source>Colour of Stop %1</source>
        <translation>Farbe von Stopp %1</translation>
    </message>
    <message>
        <source>Copy colours</source>
        <translation>Farben kopieren</translation>
    </message>
    <message>
        <source>Copy the stops as text (Ctrl+C on the bar)</source>
        <translation>Die Stopps als Text kopieren (Strg+C auf dem Balken)</translation>
    </message>
    <message>
        <source>Paste colours</source>
        <translation>Farben einfügen</translation>
    </message>
    <message>
        <source>Show the stops that were copied, here or from any text such as 0 #201040, 1 #fff0b0 (Ctrl+V on the bar)</source>
        <translation>Kopierte Stopps zeigen, von hier oder aus einem Text wie 0 #201040, 1 #fff0b0 (Strg+V auf dem Balken)</translation>
    </message>
    <message>
        <source>Pick colour</source>
        <translation>Farbe aufnehmen</translation>
    </message>
    <message>
        <source>Take the selected stop&apos;s colour from the strip&apos;s pictures or anywhere on the screen: click or Enter picks, Escape doesn&apos;t</source>
        <translation>Die Farbe des gewählten Stopps aus den Bildern des Streifens oder vom Bildschirm nehmen: Klick oder Eingabetaste nimmt auf, Esc nicht</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::ColorSpacePlot</name>
    <message>
        <source>Colours in RGB</source>
        <translation>Farben in RGB</translation>
    </message>
    <message>
        <source>The sample&apos;s colours in the RGB cube: dots are the strip&apos;s column averages, the line is its gradient.
Drag or use the arrow keys to turn it; double-click or Home turns it back.</source>
        <translation>Die Farben der Probe im RGB-Würfel: Punkte sind die Spaltenmittel des Streifens, die Linie ist sein Verlauf.
Ziehen oder die Pfeiltasten drehen ihn; Doppelklick oder Pos1 dreht ihn zurück.</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>No strip</source>
        <translation>Kein Streifen</translation>
    </message>
    <message>
        <source>· averages
— gradient</source>
        <translation>· Mittelwerte
— Verlauf</translation>
    </message>
    <message>
        <source>· averages
— gradient
▪ in use</source>
        <translation>· Mittelwerte
— Verlauf
▪ verwendet</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::CompareBar</name>
    <message>
        <source> panes</source>
        <translation> Bilder</translation>
    </message>
    <message>
        <source>Panes side by side</source>
        <translation>Bilder nebeneinander</translation>
    </message>
    <message>
        <source>How many methods are shown side by side</source>
        <translation>Wie viele Verfahren nebeneinander gezeigt werden</translation>
    </message>
    <message>
        <source>Wipe position</source>
        <translation>Ort der Trennlinie</translation>
    </message>
    <message>
        <source>How much of the picture the first method fills, in % ([ and ])</source>
        <translation>Wie viel des Bildes das erste Verfahren füllt, in % ([ und ])</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Wipe angle</source>
        <translation>Winkel der Trennlinie</translation>
    </message>
    <message>
        <source>How far the line is turned, clockwise in degrees (Alt+[ and Alt+])</source>
        <translation>Wie weit die Linie gedreht ist, im Uhrzeigersinn in Grad (Alt+[ und Alt+])</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Share of the second method, %</source>
        <translation>Anteil des zweiten Verfahrens, %</translation>
    </message>
    <message>
        <source>How much of the second method is laid over the first, in % ([ and ])</source>
        <translation>Wie viel des zweiten Verfahrens über dem ersten liegt, in % ([ und ])</translation>
    </message>
    <message>
        <source>Share of the second method</source>
        <translation>Anteil des zweiten Verfahrens</translation>
    </message>
    <message>
        <source>Gain of the difference</source>
        <translation>Verstärkung der Differenz</translation>
    </message>
    <message>
        <source>What the difference of the two pictures is multiplied with, so that little shows as well ([ and ])</source>
        <translation>Womit die Differenz der beiden Bilder multipliziert wird, damit man auch Kleines sieht ([ und ])</translation>
    </message>
    <message>
        <source>× </source>
        <translation>× </translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::CompareView</name>
    <message>
        <source>Wipe line</source>
        <translation>Trennlinie</translation>
    </message>
    <message>
        <source>First picture</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Second picture</source>
        <translation>Zweites Bild</translation>
    </message>
    <message>
        <source>Third picture</source>
        <translation>Drittes Bild</translation>
    </message>
    <message>
        <source>At %1 % of the width and %2 % of the height, turned by %3°</source>
        <translation>Bei %1 % der Breite und %2 % der Höhe, um %3° gedreht</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::CoreText</name>
    <message>
        <source>on or off</source>
        <translation>an oder aus</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>a range</comment>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::CoverageBar</name>
    <message>
        <source>Coverage</source>
        <translation>Abdeckung</translation>
    </message>
    <message>
        <source>Coverage is not known yet</source>
        <translation>Die Abdeckung ist noch nicht bekannt</translation>
    </message>
    <message>
        <source>%1 in the first pass</source>
        <translation>%1 im ersten Durchgang</translation>
    </message>
    <message>
        <source>%1 in another pass</source>
        <translation>%1 in einem weiteren Durchgang</translation>
    </message>
    <message>
        <source>%1 in %2 further passes</source>
        <translation>%1 in %2 weiteren Durchgängen</translation>
    </message>
    <message>
        <source>%L1 without area</source>
        <translation>%L1 ohne Fläche</translation>
    </message>
    <message>
        <source> · </source>
        <translation> · </translation>
    </message>
    <message>
        <source>Of %L1 faces: %2</source>
        <translation>Von %L1 Flächen: %2</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::CropCanvas</name>
    <message>
        <source>Crop</source>
        <translation>Zuschnitt</translation>
    </message>
    <message>
        <source>Drag the corners, edges or the whole to cut the strip out of the scan.
Keys 1 to 4 select a corner, 5 to 8 an edge, 0 the whole; arrow keys nudge it by a pixel, with Shift by ten.</source>
        <translation>Ecken, Kanten oder das Ganze ziehen, um den Streifen aus dem Scan zu schneiden.
Die Tasten 1 bis 4 wählen eine Ecke, 5 bis 8 eine Kante, 0 das Ganze; Pfeiltasten rücken um ein Pixel, mit Umschalt um zehn.</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::GradientCurveEditor</name>
    <message>
        <source>Place on the strip</source>
        <translation>Ort auf dem Streifen</translation>
    </message>
    <message>
        <source>The selected point&apos;s place on the strip, 0 dark to 1 light</source>
        <translation>Ort des gewählten Punkts auf dem Streifen, 0 dunkel bis 1 hell</translation>
    </message>
    <message>
        <source>Place on the gradient</source>
        <translation>Ort auf dem Verlauf</translation>
    </message>
    <message>
        <source>The selected point&apos;s place on the gradient, 0 to 1</source>
        <translation>Ort des gewählten Punkts auf dem Verlauf, 0 bis 1</translation>
    </message>
    <message>
        <source>Remove point</source>
        <translation>Punkt entfernen</translation>
    </message>
    <message>
        <source>Remove the selected point (Delete)</source>
        <translation>Gewählten Punkt entfernen (Entf)</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Begradigen</translation>
    </message>
    <message>
        <source>Back to a straight curve</source>
        <translation>Zurück zur geraden Kurve</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::HeatOverlay</name>
    <message>
        <source>Heat map</source>
        <translation>Heatmap</translation>
    </message>
    <message>
        <source>%1, 0 to %2</source>
        <translation>%1, 0 bis %2</translation>
    </message>
    <message>
        <source>best match in the strip</source>
        <translation>ähnlichste Stelle im Streifen</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::LightSphere</name>
    <message>
        <source>Drag to turn the light (Shift and the right button do so anywhere in the picture)</source>
        <translation>Ziehen dreht das Licht (Umschalt mit der rechten Taste überall im Bild)</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::MessageBar</name>
    <message>
        <source>Close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::MetricLegend</name>
    <message>
        <source>Curves</source>
        <translation>Kurven</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::PaneLabel</name>
    <message>
        <source>Which method this is; choose another</source>
        <translation>Welches Verfahren dies ist; ein anderes wählen</translation>
    </message>
    <message>
        <source>What this picture&apos;s frame took, in milliseconds, and its errors: how little it resembles its strips, and how far its shades are from the light, each from 0 to 1</source>
        <translation>Wie lange dieses Bild brauchte, in Millisekunden, und seine Fehler: wie wenig es seinen Streifen ähnelt und wie weit seine Töne vom Licht abweichen, je 0 bis 1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::ParameterForm</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück zu %1</translation>
    </message>
    <message>
        <source>%1
Range %2, default %3</source>
        <translation>%1
Bereich %2, Standard %3</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::PictureView</name>
    <message>
        <source>Shadows: these are the CPU renderer&apos;s pictures.</source>
        <translation>Schatten: Diese Bilder zeichnet die CPU.</translation>
    </message>
    <message>
        <source>No OpenGL here: these are the CPU renderer&apos;s pictures.</source>
        <translation>Kein OpenGL: Diese Bilder zeichnet die CPU.</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::SampleView</name>
    <message>
        <source>Turn left</source>
        <translation>Nach links drehen</translation>
    </message>
    <message>
        <source>Turn the strip a quarter to the left</source>
        <translation>Den Streifen um ein Viertel nach links drehen</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>Nach rechts drehen</translation>
    </message>
    <message>
        <source>Turn the strip a quarter to the right</source>
        <translation>Den Streifen um ein Viertel nach rechts drehen</translation>
    </message>
    <message>
        <source>Mirror</source>
        <translation>Spiegeln</translation>
    </message>
    <message>
        <source>Swap left and right, for scans with light on the left</source>
        <translation>Links und rechts tauschen, für Scans mit Hell auf der linken Seite</translation>
    </message>
    <message>
        <source>Whole scan</source>
        <translation>Ganzer Scan</translation>
    </message>
    <message>
        <source>Use the whole scan</source>
        <translation>Den ganzen Scan verwenden</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::SpeedCurvePlot</name>
    <message>
        <source>Speed curve</source>
        <translation>Tempokurve</translation>
    </message>
    <message>
        <source>How fast the gradient&apos;s colours pass along the strip.
Drag a point; double-click adds one, Delete removes it.
Page Up and Page Down select a point, the arrow keys nudge it (Shift: more).
Below: the strip&apos;s column averages, and the gradient that should follow them.</source>
        <translation>Wie schnell die Farben des Verlaufs am Streifen entlang wechseln.
Einen Punkt ziehen; ein Doppelklick fügt einen hinzu, Entf entfernt ihn.
Bild auf und Bild ab wählen einen Punkt, die Pfeiltasten rücken ihn (Umschalt: weiter).
Darunter: die Spaltenmittel des Streifens und der Verlauf, der ihnen folgen soll.</translation>
    </message>
    <message>
        <source>No strip</source>
        <translation>Kein Streifen</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::StripView</name>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>The strip, dark to light</source>
        <translation>Der Streifen, dunkel bis hell</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>Mittelwerte</translation>
    </message>
    <message>
        <source>The mean colour of each column</source>
        <translation>Die mittlere Farbe jeder Spalte</translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>The sorted colours at the speed of the curve, G(u(x))</source>
        <translation>Die sortierten Farben im Tempo der Kurve, G(u(x))</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>The strip without its gradient, on middle grey</source>
        <translation>Der Streifen ohne seinen Verlauf, auf mittlerem Grau</translation>
    </message>
    <message>
        <source>Recoloured</source>
        <translation>Umgefärbt</translation>
    </message>
    <message>
        <source>The texture over the gradient in use</source>
        <translation>Die Textur über dem verwendeten Verlauf</translation>
    </message>
    <message>
        <source>Strip, averages, gradient and texture</source>
        <translation>Streifen, Mittelwerte, Verlauf und Textur</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 key at frame %2; drag to move it, Delete removes it</source>
        <translation>%1: Schlüsselbild bei Bild %2; Ziehen verschiebt es, Entf entfernt es</translation>
    </message>
    <message>
        <source>Frames %1 to %2 are rendered; drag an end</source>
        <translation>Bild %1 bis %2 werden gerendert; ein Ende ziehen</translation>
    </message>
    <message>
        <source>Frame %1; drag to go through the frames</source>
        <translation>Bild %1; Ziehen geht durch die Bilder</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::VectorEdit</name>
    <message>
        <source>%1 along %2; arrow keys and the wheel change it</source>
        <translation>%1 entlang %2; Pfeiltasten und Mausrad ändern den Wert</translation>
    </message>
    <message>
        <source>Keep proportions</source>
        <translation>Proportionen halten</translation>
    </message>
    <message>
        <source>Change all three in proportion</source>
        <translation>Alle drei im Verhältnis ändern</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the standard</source>
        <translation>Zurück zum Standard</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::ViewSphere</name>
    <message>
        <source>Views around the object</source>
        <translation>Ansichten um das Objekt</translation>
    </message>
    <message>
        <source>1 view</source>
        <translation>1 Ansicht</translation>
    </message>
    <message>
        <source>%1 views</source>
        <translation>%1 Ansichten</translation>
    </message>
    <message>
        <source>View %1 of %2, placed</source>
        <translation>Ansicht %1 von %2, gesetzt</translation>
    </message>
    <message>
        <source>View %1 of %2, planned</source>
        <translation>Ansicht %1 von %2, geplant</translation>
    </message>
    <message>
        <source>Drag a view to move it, drag beside the views to turn the sphere</source>
        <translation>Eine Ansicht ziehen verschiebt sie, daneben ziehen dreht die Kugel</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>unten</translation>
    </message>
    <message>
        <source>front</source>
        <translation>vorn</translation>
    </message>
    <message>
        <source>back</source>
        <translation>hinten</translation>
    </message>
</context>
<context>
    <name>chiaro::widgets::Viewport</name>
    <message>
        <source>Viewport</source>
        <translation>3D-Ansicht</translation>
    </message>
</context>
</TS>
