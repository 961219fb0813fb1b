#include "modeler/catalogue/kind_table.h"

namespace enfilade::modeler {
namespace {

using Range = std::array<double, 2>;

constexpr Range on_floor = {0, 0.6};
constexpr Range on_something = {0, 1.6};
constexpr Range anywhere = {0, 4};

constexpr KindWords beds[] = {
    {"bunk_bed",
     "bunk bed|loft bed|mezzanine bed|etagenbett|hochbett|lits superposes|lit mezzanine|letto a castello|litera",
     {0.7, 2.2},
     {1.5, 2.8},
     {1.3, 2.4}},
    {"cot",
     "cot|crib|baby bed|cradle|kinderbett|gitterbett|babybett|lit bebe|berceau|culla|cuna",
     {0.4, 1},
     {0.6, 1.6},
     {0.5, 1.4}},
    {"double_bed",
     "double bed|king bed|queen bed|bed|doppelbett|ehebett|bett|lit double|grand lit|lit|letto matrimoniale|letto "
     "doppio|"
     "letto|cama doble|cama matrimonial|cama",
     {1.25, 2.3},
     {1.8, 2.5},
     {0.25, 2.2}},
    {"bed",
     "single bed|child bed|day bed|iron bed|captains bed|bed|einzelbett|bett|lit simple|lit enfant|lit|letto "
     "singolo|"
     "letto|cama individual|cama",
     {0.65, 2.2},
     {0.65, 2.4},
     {0.15, 1.6}},
    {"bedside_table",
     "bedside table|bedside cabinet|nightstand|night stand|night table|nachttisch|nachtkommode|table de chevet|"
     "table de nuit|chevet|comodino|mesita de noche|mesilla",
     {0.25, 0.8},
     {0.2, 0.7},
     {0.3, 0.85}},
    {"wardrobe",
     "wardrobe|closet|armoire|cupboard|kleiderschrank|schrank|garde robe|penderie|guardaroba|armadio|armario|ropero",
     {0.4, 4},
     {0.3, 1.1},
     {1.3, 2.8}},
    {"chest_of_drawers",
     "chest of drawers|dresser|dresser with drawers|drawers|drawer unit|drawers "
     "cabinet|commode|kommode|cassettiera|como|comoda|"
     "cajonera",
     {0.35, 2},
     {0.25, 0.8},
     {0.4, 1.5}},
    {"dressing_table",
     "dressing table|vanity table|make up table|schminktisch|frisiertisch|coiffeuse|toeletta|tocador",
     {0.5, 1.6},
     {0.3, 0.8},
     {0.6, 1.8}},
    {"mirror", "mirror|spiegel|miroir|specchio|espejo", {0.15, 2.5}, {0.005, 0.5}, {0.15, 2.3}, anywhere},
};

constexpr KindWords seats[] = {
    {"sofa",
     "sofa|couch|settee|loveseat|canape|divano|sofa bed|convertible sofa|corner sofa|ecksofa|schlafsofa"
     "futon couch",
     {1.15, 4},
     {0.6, 2.8},
     {0.5, 1.3}},
    {"armchair",
     "armchair|arm chair|easy chair|lounge chair|sessel|fauteuil|poltrona|sillon|butaca",
     {0.45, 1.3},
     {0.45, 1.2},
     {0.6, 1.3}},
    {"office_chair",
     "office chair|desk chair|swivel chair|task chair|kids desk chair|burostuhl|drehstuhl|chaise de bureau|sedia da "
     "ufficio|"
     "sedia ufficio|silla de oficina",
     {0.4, 0.85},
     {0.4, 0.85},
     {0.7, 1.4}},
    {"bar_stool",
     "bar stool|bar chair|counter stool|stool|barhocker|tabouret de bar|sgabello|taburete de bar",
     {0.25, 0.65},
     {0.25, 0.65},
     {0.6, 1.2}},
    {"stool",
     "stool|footstool|pouf|puff|piano bench|hocker|tabouret|sgabello|taburete",
     {0.25, 0.95},
     {0.25, 0.95},
     {0.3, 0.65}},
    {"bench", "bench|sitzbank|bank|banc|panca|banco", {0.7, 2.6}, {0.25, 0.8}, {0.3, 1.1}},
    {"chair", "chair|dining chair|kitchen chair|stuhl|chaise|sedia|silla", {0.33, 0.85}, {0.35, 0.9}, {0.65, 1.3}},
};

constexpr KindWords tables[] = {
    {"coffee_table",
     "coffee table|side table|low table|end table|saloon table|living room table|table|couchtisch|beistelltisch|table "
     "basse|"
     "tavolino|mesa de centro|mesa baja",
     {0.35, 1.8},
     {0.3, 1.3},
     {0.25, 0.62}},
    {"tv_stand",
     "tv stand|tv unit|tv cabinet|tv bench|television cabinet|television stand|tv mobel|fernsehtisch|meuble tv|meuble "
     "tele|"
     "mobile tv|porta tv|mueble tv|mueble de tv",
     {0.5, 3},
     {0.25, 0.8},
     {0.2, 1.7}},
    {"round_table",
     "round table|runder tisch|table ronde|tavolo rotondo|tavolo tondo|mesa redonda",
     {0.55, 2},
     {0.55, 2},
     {0.65, 1.15}},
    {"meeting_table",
     "meeting table|conference table|besprechungstisch|konferenztisch|table de reunion|table de conference|tavolo "
     "riunioni|"
     "mesa de reuniones|mesa de juntas",
     {1.2, 6},
     {0.8, 2.5},
     {0.65, 0.85}},
    {"dining_table",
     "dining table|kitchen table|rectangular table|table|esstisch|kuchentisch|tisch|table a manger|tavolo da "
     "pranzo|tavolo|"
     "mesa de comedor|mesa",
     {0.55, 3.5},
     {0.5, 1.6},
     {0.64, 1}},
    {"desk",
     "desk|writing desk|computer desk|office table|schreibtisch|bureau|scrivania|escritorio",
     {0.8, 2.5},
     {0.4, 1.3},
     {0.65, 1.9}},
    {"reception_desk",
     "reception desk|reception|counter desk|empfangstheke|banque daccueil|bancone reception|recepcion",
     {1, 5},
     {0.5, 3},
     {0.7, 1.4}},
};

constexpr KindWords living[] = {
    {"bookshelf",
     "bookshelf|book shelf|bookcase|book case|full bookcase|bucherregal|bibliotheque|libreria|estanteria|librero",
     {0.3, 3.2},
     {0.15, 0.7},
     {0.7, 2.7}},
    {"wall_shelf",
     "wall shelf|shelf|shelves|cube shelf|wandregal|etagere murale|mensola|balda",
     {0.2, 2.6},
     {0.1, 0.5},
     {0.02, 1},
     {0.7, 2.4}},
    {"shelf",
     "shelf|shelves|shelving|cube shelf|rack|regal|etagere|scaffale|mensola|estante",
     {0.2, 2.6},
     {0.1, 0.7},
     {0.1, 2.6}},
    {"sideboard", "sideboard|buffet|credenza|chest|aparador|anrichte|enfilade", {0.7, 3}, {0.3, 0.8}, {0.45, 1.3}},
    {"tv",
     "tv|flat tv|television|fernseher|televiseur|televisore|televisor",
     {0.4, 2.2},
     {0.02, 0.7},
     {0.25, 1.3},
     on_something},
    {"piano", "piano|upright piano|grand piano|klavier|flugel|pianoforte", {1.2, 1.8}, {0.4, 2.9}, {0.9, 2}},
    {"fireplace", "fireplace|kamin|cheminee|camino|caminetto|chimenea", {0.6, 2.5}, {0.2, 1.2}, {0.6, 2.8}},
    {"rug", "rug|carpet|oriental rug|teppich|tapis|tappeto|alfombra", {0.4, 5}, {0.3, 5}, {0.001, 0.06}},
    {"picture",
     "picture|painting|poster|picture frame|frame|bild|gemalde|tableau|cadre|quadro|cuadro",
     {0.2, 3},
     {0.005, 0.1},
     {0.1, 2.5},
     anywhere},
    {"curtain",
     "curtain|curtains|drape|vorhang|gardine|rideau|tenda|cortina",
     {0.4, 5},
     {0.02, 0.4},
     {0.6, 3.2},
     {0, 1.5}},
    {"plant",
     "plant|indoor plant|yucca|ficus|palm|bonsai|bamboo|decorative plant|pflanze|zimmerpflanze|plante|pianta|planta",
     {0.2, 1.3},
     {0.2, 1.3},
     {0.55, 2.2}},
    {"small_plant",
     "plant|little plant|cactus|flowers|orchid|orchids|bonsai|tulips|bamboo|succulent "
     "plant|spathiphyllum|pflanze|blumen|"
     "plante|fleurs|pianta|fiori|planta|flores",
     {0.05, 0.75},
     {0.05, 0.75},
     {0.08, 0.7},
     on_something},
    {"vase", "vase|vaso|jarron|jar", {0.05, 0.6}, {0.05, 0.6}, {0.1, 1.1}, on_something},
    {"book_pile",
     "books|book pile|pile of books|bucher|livres|libri|libros",
     {0.08, 0.6},
     {0.08, 0.6},
     {0.03, 0.6},
     on_something},
    {"cup", "cup|mug|coffee cup|coffee mug|tasse|tazza|taza", {0.05, 0.16}, {0.05, 0.16}, {0.03, 0.16}, on_something},
};

constexpr KindWords lamps[] = {
    {"ceiling_lamp",
     "ceiling lamp|ceiling light|pendant lamp|pendant light|hanging light|hanging lamp|chandelier|chandelier lamp|"
     "lamp|deckenlampe|deckenleuchte|hangelampe|plafonnier|suspension|lustre|lampadario|plafoniera|"
     "lampara de techo",
     {0.08, 1.6},
     {0.08, 1.6},
     {0.02, 2},
     {1.1, 4}},
    {"office_lamp",
     "office light|fluorescent light|fluorescent strip|fluorescent lamp|leuchtstofflampe|tube fluorescent|neon",
     {0.08, 2.5},
     {0.04, 2.5},
     {0.02, 1},
     {1.1, 4}},
    {"wall_lamp",
     "wall lamp|wall light|wall uplight|sconce|wall spotlight|wall lamp artwork|wandlampe|wandleuchte|applique|"
     "lampada da parete|aplique",
     {0.04, 0.7},
     {0.04, 0.5},
     {0.05, 0.8},
     {0.9, 2.6}},
    {"desk_lamp",
     "desk lamp|work lamp|schreibtischlampe|lampe de bureau|lampada da scrivania|lampara de escritorio",
     {0.08, 0.6},
     {0.08, 0.7},
     {0.2, 0.9},
     on_something},
    {"floor_lamp",
     "floor lamp|standing lamp|floor uplight|lamp|stehlampe|stehleuchte|lampadaire|piantana|lampada da terra|"
     "lampara de pie",
     {0.12, 1.3},
     {0.12, 1.3},
     {1.05, 2.3}},
    {"table_lamp",
     "table lamp|bedside lamp|little lamp|pedestal vase lamp|lamp|tischlampe|lampe de chevet|lampe de table|lampe|"
     "lampada da tavolo|lampada|lampara de mesa|lampara",
     {0.08, 0.6},
     {0.08, 0.6},
     {0.15, 0.95},
     on_something},
};

constexpr KindWords office[] = {
    {"computer",
     "computer|laptop|imac|apple imac|ibook|monitor|notebook|rechner|ordinateur|ordenador",
     {0.2, 1},
     {0.1, 0.8},
     {0.15, 0.7},
     on_something},
    {"filing_cabinet",
     "filing cabinet|file cabinet|aktenschrank|classeur|schedario|archivador",
     {0.3, 1.3},
     {0.3, 0.9},
     {0.45, 2.2}},
    {"whiteboard",
     "whiteboard|white board|flip chart|flipchart|tableau blanc|lavagna|pizarra",
     {0.5, 4},
     {0.01, 0.8},
     {0.5, 2.2},
     anywhere},
    {"printer",
     "printer|copier|photocopier|inkjet printer and scanner|drucker|imprimante|stampante|impresora",
     {0.25, 1.3},
     {0.2, 0.9},
     {0.1, 1.4},
     on_something},
    {"server_rack",
     "server rack|server cabinet|serverschrank|baie serveur|rack server",
     {0.4, 1.3},
     {0.4, 1.3},
     {0.6, 2.3}},
    {"vending_machine",
     "vending machine|water cooler|getrankeautomat|distributeur|distributore automatico|maquina expendedora",
     {0.25, 1.6},
     {0.25, 1.2},
     {1, 2.2}},
    {"locker", "locker|lockers|spind|casier|vestiaire|armadietto|taquilla", {0.25, 2}, {0.3, 0.8}, {0.8, 2.3}},
    {"bin",
     "bin|dustbin|trash can|trashcan|waste basket|recycling bin|bullet trash "
     "can|mulleimer|papierkorb|poubelle|corbeille|"
     "cestino|pattumiera|papelera|cubo de basura",
     {0.15, 0.6},
     {0.15, 0.6},
     {0.2, 1}},
    {"box", "box|cardboard box|crate|carton|karton|kiste|scatola|caja", {0.15, 1}, {0.15, 0.9}, {0.1, 0.8}},
    {"bicycle", "bicycle|bike|fahrrad|velo|bicicletta|bicicleta", {0.3, 0.8}, {1, 2}, {0.6, 1.3}},
    {"coat_rack",
     "coat rack|coat stand|coat hanger|clothes rack|garderobenstander|kleiderstander|porte manteau|appendiabiti|"
     "attaccapanni|perchero",
     {0.25, 1.6},
     {0.2, 0.8},
     {1.1, 2.2}},
    {"umbrella_stand",
     "umbrella stand|schirmstander|porte parapluie|portaombrelli|paraguero",
     {0.12, 0.6},
     {0.12, 0.6},
     {0.3, 1}},
    {"shoe_cabinet",
     "shoe cabinet|shoe rack|schuhschrank|meuble a chaussures|scarpiera|zapatero",
     {0.4, 1.6},
     {0.12, 0.5},
     {0.3, 1.6}},
};

constexpr KindWords wet_rooms[] = {
    {"kitchen_unit",
     "lower cabinet|base cabinet|kitchen unit|kitchen base|kitchen cabinet|kitchen lower cabinet|small lower cabinet|"
     "island extension|drawers cabinet|kitchen drawers cabinet|unterschrank|meuble bas|mobile base|mueble bajo",
     {0.25, 2.6},
     {0.4, 0.9},
     {0.7, 1.05}},
    {"kitchen_sink",
     "kitchen sink|sink|sink cabinet|spule|spulbecken|spulschrank|evier|lavello|fregadero",
     {0.4, 1.9},
     {0.4, 0.9},
     {0.7, 1.4}},
    {"stove",
     "stove|cooker|large stove|oven|double oven|range|herd|backofen|cuisiniere|four|fornello|cucina|forno|cocina|horno",
     {0.4, 1.3},
     {0.45, 0.9},
     {0.7, 1.5}},
    {"fridge",
     "fridge|refrigerator|fridge freezer|freezer|large "
     "fridge|kuhlschrank|refrigerateur|frigo|frigorifero|frigorifico|nevera",
     {0.45, 1.3},
     {0.45, 1.05},
     {0.75, 2.2}},
    {"dishwasher",
     "dishwasher|geschirrspuler|spulmaschine|lave vaisselle|lavastoviglie|lavavajillas",
     {0.4, 0.7},
     {0.45, 0.75},
     {0.7, 1}},
    {"wall_cabinet",
     "wall cabinet|upper cabinet|kitchen upper cabinet|small upper cabinet|glass door cabinet|upper shelves cabinet|"
     "hangeschrank|oberschrank|meuble haut|pensile|mueble alto",
     {0.25, 2},
     {0.2, 0.5},
     {0.25, 1.1},
     {0.9, 2.2}},
    {"toilet",
     "toilet|toilets unit|toilet unit|wc|toilette|klo|water|vaso sanitario|inodoro|retrete",
     {0.3, 0.6},
     {0.4, 0.95},
     {0.3, 1.2},
     {0, 0.3}},
    {"wash_basin",
     "wash basin|washbasin|basin|lavatory|small lavatory|bathroom sink|vanity|double "
     "vanity|waschbecken|waschtisch|lavabo|vasque|lavandino|lavamanos",
     {0.25, 2},
     {0.25, 0.95},
     {0.3, 2.3},
     {0, 1}},
    {"bathtub",
     "bathtub|bath tub|bath|fitted bath|corner bathtub|island bath|badewanne|baignoire|vasca|vasca da bagno|banera",
     {0.65, 2.2},
     {0.65, 2.2},
     {0.3, 1.2}},
    {"shower",
     "shower|shower stall|shower cabin|shower tray|dusche|duschkabine|douche|doccia|ducha",
     {0.65, 1.7},
     {0.65, 1.7},
     {0.02, 2.5}},
    {"washing_machine",
     "washing machine|clothes washing machine|clothes washer|washer|dryer|dryer machine|tumble "
     "dryer|waschmaschine|trockner|"
     "lave linge|machine a laver|seche linge|lavatrice|asciugatrice|lavadora|secadora",
     {0.4, 0.75},
     {0.35, 0.75},
     {0.6, 1.1}},
    {"towel_rail",
     "towel rail|towel rack|towel radiator|radiator and towels|handtuchhalter|handtuchheizkorper|porte serviettes|"
     "seche serviettes|porta asciugamani|toallero",
     {0.3, 1},
     {0.02, 0.3},
     {0.05, 1.9},
     {0, 1.6}},
    {"radiator",
     "radiator|hot water radiator|heater|heizkorper|radiateur|radiatore|termosifone|radiador",
     {0.3, 3},
     {0.03, 0.5},
     {0.2, 1.4},
     {0, 0.8}},
};

template <std::size_t... Sizes>
constexpr auto joined(const KindWords (&... parts)[Sizes]) {
    std::array<KindWords, (Sizes + ...)> all{};
    std::size_t at = 0;
    const auto copy = [&](const auto& part) {
        for (const KindWords& row : part) all[at++] = row;
    };
    (copy(parts), ...);
    return all;
}

constexpr auto table = joined(beds, seats, tables, living, lamps, office, wet_rooms);

}  // namespace

std::span<const KindWords> kind_table() { return table; }

std::string_view phrases_of_no_kind() {
    return "shower curtain|shower door|shower head|toilet brush|toilet paper|paper towel|towel holder|christmas tree|"
           "table tennis|pool table|football table|billiard|changing table|hospital bed|wheelchair|high chair|child "
           "chair|"
           "children chair|children table|child hut|toy|doll|doll "
           "house|puzzle|model|statue|people|human|mannequin|garden|"
           "outdoor|outdoors|beach|deck|park|street|camping|tent|abdominal|indoor bike|tv remote|remote control|bread "
           "box|"
           "medicine box|ammo box|card game|knife stand|letter tray|birthday|car|hedge|under snow|window blind|baby "
           "bottle|"
           "coffee maker|coffee machine|coffee press|cup cake|air mattress|sleeping bag|chair ottoman|table fan|bed "
           "sheet|"
           "contemporary living room|staircase|treppe|escalier|scala|escalera|railing|gelander|induction cooker|"
           "propane stove|small oven|stone grill|bread|television remote|clothes hanger|high cabinet|water "
           "heater|chest freezer";
}

std::string_view categories_of_no_kind() {
    return "characters|exterior|vehicles|staircases|doors and "
           "windows|people|animals|garden|personen|fahrzeuge|aussen|treppen|"
           "personnages|exterieur|vehicules|escaliers|persone|esterni|veicoli|scale|personajes|vehiculos|escaleras";
}

}  // namespace enfilade::modeler
