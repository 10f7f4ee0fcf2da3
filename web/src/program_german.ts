// The German of what the program itself says most often: refusals, remarks on plans and drives, what was mended in a file. {0}, {1} … are values, in
// the order of the English sentence. What is not here is shown as the program says it. A test finds each sentence in the program's sources.
export const PROGRAM: Readonly<Record<string, string>> = {
  // Remarks on plans
  '{0} % of the land, {1} m², stays unworked': '{0} % der Fläche, {1} m², bleiben unbearbeitet',
  '{0} m² of what stays unworked lie where the land is narrower than the machine': '{0} m² davon liegen, wo die Fläche schmaler als die Maschine ist',
  'swaths pass the field boundary by up to {0} m ({1} m² in all); say that the machine cannot leave the field to turn, and they stay inside':
    'Bahnen gehen bis zu {0} m über die Feldgrenze hinaus (insgesamt {1} m²); geben Sie an, dass die Maschine das Feld zum Wenden nicht verlassen kann, dann bleiben sie innerhalb',
  '{0} m² between obstacles, or between obstacles and the edge, are narrower than the machine and are given up':
    '{0} m² zwischen Hindernissen, oder zwischen Hindernissen und dem Rand, sind schmaler als die Maschine und werden aufgegeben',
  '{0} m² are left out on purpose and count as uncovered': '{0} m² sind absichtlich ausgelassen und zählen als nicht bearbeitet',
  '{0} headland passes round the field were asked for, and there is room for {1}': 'Gewünscht waren {0} Vorgewenderunden um das Feld; Platz ist für {1}',
  'the field is worked by its headland passes alone: they leave no room for tracks': 'das Feld wird allein von seinen Vorgewenderunden bearbeitet: Sie lassen keinen Platz für Spuren',
  'not worth the way: {0} {1}, {2} m in all, would cost more to drive to and work than the land is worth': 'den Weg nicht wert: {0} {1}, insgesamt {2} m, hinzufahren und sie zu bearbeiten würde mehr kosten, als das Land wert ist',
  'not driven: {0} {1} shorter than {2} m, {3} m in all': 'nicht gefahren: {0} {1}, kürzer als {2} m, insgesamt {3} m',
  'shortened: {0} {1} of tracks, by up to {2} m: there the machine turns at once, where it would have to stop or to drive a loop farther on':
    'gekürzt: {0} {1} von Spuren, um bis zu {2} m: Dort wendet die Maschine in einem Zug, wo sie weiter außen anhalten oder eine Schleife fahren müsste',
  end: 'Ende',
  ends: 'Enden',
  piece: 'Stück',
  pieces: 'Stücke',
  '{0} of {1} tracks {2} shorter than {3} m, twice the turning radius and the working width: hardly worth turning for':
    'von {1} Spuren {2} {0} kürzer als {3} m (doppelter Wenderadius und Arbeitsbreite): Dafür lohnt das Wenden kaum',
  is: 'ist',
  are: 'sind',
  'the route leaves the land on {0} of its {1} legs, by up to {2} m: no way has room there':
    'die Route verlässt auf {0} ihrer {1} Abschnitte die Fläche, um bis zu {2} m: Dort hat kein Weg Platz',
  '{0} m of the route, {1} %, are driven in reverse, up to {2} m at a time: where tracks and passes end the machine has no room to turn':
    '{0} m der Route, {1} %, werden rückwärts gefahren, bis zu {2} m am Stück: Wo Spuren und Vorgewendefahrten enden, hat die Maschine keinen Platz zum Wenden',
  'corners of the machine swing out over the edge of the land by up to {0} m where headland passes turn, whichever way they are driven':
    'Ecken der Maschine schwenken in den Kurven der Vorgewenderunden bis zu {0} m über den Rand der Fläche, wie auch immer gefahren wird',
  'the land falls into {0} parts for a machine as wide as this: the route works one after the other, and leaves the land from each to the next':
    'für eine so breite Maschine zerfällt die Fläche in {0} Teile: Die Route bearbeitet einen nach dem anderen und verlässt von jedem zum nächsten die Fläche',
  'connections between tracks are not planned yet: only the order of the pieces is': 'die Wege zwischen den Spuren sind noch nicht geplant, nur die Reihenfolge der Stücke',
  'the search was ended before it was through: a longer one may find a cheaper plan': 'die Suche wurde vor ihrem Ende beendet: Eine längere findet vielleicht einen günstigeren Plan',
  'a part of {0} at {1}, {2} m², is smaller than {3} m² or narrower than the working width and is joined to {4}':
    'ein Teil von {0} bei {1}, {2} m², ist kleiner als {3} m² oder schmaler als die Arbeitsbreite und wird zu {4} genommen',

  // What cannot be planned
  "no swath {0} m wide fits into the field '{1}' of {2} m²: use a narrower machine": 'in das Feld „{1}“ von {2} m² passt keine Bahn von {0} m Breite: Nehmen Sie eine schmalere Maschine',
  "no track fits into field '{0}' of {1} m² with a working width of {2} m{3} and pieces of at least {4} m: use a narrower machine, shorter pieces{5} or {6}":
    'in das Feld „{0}“ von {1} m² passt keine Spur mit einer Arbeitsbreite von {2} m{3} und Stücken von mindestens {4} m: Nehmen Sie eine schmalere Maschine, kürzere Stücke{5} oder {6}',
  'another end rule': 'eine andere Regel für die Enden der Bahnen',
  'fewer headland passes': 'weniger Vorgewendefahrten',
  'a field that the machine can leave': 'ein Feld, das die Maschine verlassen kann',
  ', a clearance of {0} m from obstacles': ', einem Abstand von {0} m zu Hindernissen',
  ', a smaller clearance': ', einen kleineren Abstand',
  "the field '{0}' is worked by its headland passes alone, so there are no plans to compare": 'das Feld „{0}“ wird allein von seinen Vorgewenderunden bearbeitet, es gibt also keine Pläne zu vergleichen',
  "{0}: the line lies outside field '{1}'; draw it in the field or along its edge": '{0}: Die Linie liegt außerhalb des Feldes „{1}“; zeichnen Sie sie in das Feld oder an seinen Rand',
  '{0}: the line has no length; give it two different points': '{0}: Die Linie hat keine Länge; geben Sie ihr zwei verschiedene Punkte',
  '{0}: the line is {1} m long, which is less than the working width of {2} m; draw a longer one': '{0}: Die Linie ist {1} m lang, also kürzer als die Arbeitsbreite von {2} m; zeichnen Sie eine längere',
  "{0}: there is no gate within {1} m of the edge of field '{2}'": '{0}: Kein Tor liegt näher als {1} m am Rand des Feldes „{2}“',
  'the land {0} does not reach the field; draw it over the field': 'die Fläche {0} reicht nicht bis an das Feld; zeichnen Sie sie über das Feld',

  // What is no field, and what was mended
  '{0}: the feature has no geometry; give it a polygon': '{0}: Das Objekt hat keine Geometrie; geben Sie ihm ein Polygon',
  "{0}: the geometry is a {1}, not a polygon with land in it; draw the field's boundary as a polygon": '{0}: Die Geometrie ist ein {1}, kein Polygon mit Fläche darin; zeichnen Sie die Feldgrenze als Polygon',
  '{0}: the field is {1} km wide; check its coordinates and choose the right coordinate reference system': '{0}: Das Feld ist {1} km breit; prüfen Sie seine Koordinaten, und wählen Sie das richtige Koordinatensystem',
  "{0}, feature '{1}': the obstacles cover the whole field; check the obstacle file": '{0}, Objekt „{1}“: Die Hindernisse bedecken das ganze Feld; prüfen Sie sie',
  'the boundary crosses itself so that it bounds several fields; draw each by itself': 'die Grenze kreuzt sich selbst und begrenzt so mehrere Felder; zeichnen Sie jedes für sich',
  'the shape drawn as obstacle {0} does not reach the field; draw it inside': 'die Form, die als Hindernis {0} gezeichnet ist, reicht nicht bis an das Feld; zeichnen Sie sie hinein',
  'there are no polygons in it': 'es sind keine Polygone darin',
  "'{0}' is empty; choose another file": '„{0}“ ist leer; wählen Sie eine andere Datei',
  '{0} touches the outer ring': '{0} berührt den äußeren Ring',
  '{0} was not closed; its last vertex was joined to its first': '{0} war nicht geschlossen; der letzte Punkt wurde mit dem ersten verbunden',
  '{0} ran {1}, against the file format; it was turned round': '{0} lief {1}, entgegen dem Dateiformat; die Richtung wurde umgekehrt',
  clockwise: 'im Uhrzeigersinn',
  'counter-clockwise': 'gegen den Uhrzeigersinn',
  '{0} ran the same way round as the outer ring; it was taken as a hole': '{0} lief in derselben Richtung wie der äußere Ring; es gilt als Loch',
  '{0} had vertex {1} in the same place as vertex {2}; one was removed': '{0} hatte Punkt {1} an derselben Stelle wie Punkt {2}; einer wurde entfernt',
  '{0} had a spike without width {1} m long; it was removed': '{0} hatte eine Spitze ohne Breite von {1} m Länge; sie wurde entfernt',
  '{0} had {1} corners; {2} were left out that lie within {3} cm of the boundary through the others': '{0} hatte {1} Ecken; weggelassen wurden {2}, die höchstens {3} cm neben der Grenze durch die übrigen liegen',
  '{0} touched or crossed itself; the land it goes round an odd number of times was kept': '{0} berührte oder kreuzte sich selbst; behalten wurde, was eine ungerade Zahl von Malen umrundet wird',
  '{0} lies outside the outer ring; it was dropped': '{0} liegt außerhalb des äußeren Rings und wurde weggelassen',
  '{0} reached outside the outer ring; the outside part was removed': '{0} reichte über den äußeren Ring hinaus; was außen liegt, wurde entfernt',
  '{0} shares an edge with the outer ring; it was kept as an obstacle at the edge': '{0} hat eine Kante mit dem äußeren Ring gemeinsam; es bleibt ein Hindernis am Rand',
  'outer ring': 'Äußerer Ring',
  'hole {0}': 'Loch {0}',

  // Remarks on drives
  '{0} of the fixes are earlier than the one before: all were put in order of time': '{0} der Positionen sind früher als die vorige: Alle wurden nach der Zeit geordnet',
  '{0} fixes do not say how wide the machine is: nothing is worked there unless you give the working width':
    '{0} Positionen sagen nicht, wie breit die Maschine ist: Dort gilt nichts als bearbeitet, solange Sie keine Arbeitsbreite angeben',

  // What the server says
  "there is no {0} '{1}'; it may have been deleted: choose another": '„{1}“ gibt es nicht ({0}); vielleicht wurde es gelöscht: Wählen Sie etwas anderes',
  'the file is not here any more; choose it again': 'die Datei ist nicht mehr da; wählen Sie sie noch einmal',
  'too much work is waiting already; try again when some of it is done': 'es wartet schon zu viel Arbeit; versuchen Sie es noch einmal, wenn etwas davon getan ist',
  'this is too much for the memory of this computer; try with less': 'das ist zu viel für den Speicher dieses Rechners; versuchen Sie es mit weniger',
  'this server asks for a token; open the address that was printed when it started, with all that stands behind its #':
    'dieser Server verlangt ein Kennwort; öffnen Sie die Adresse, die er beim Start ausgibt, mit allem, was hinter dem # steht',
};
