/** Which control shows which kind of value. */

import type { EnumField, KeyedField, ListField, NumberField, PlainField, VectorField } from "../schema";
import { booleanControl, enumControl, jsonControl, textControl } from "./choice";
import { el } from "../dom";
import { colorControl } from "./color";
import type { Control, Place } from "./control";
import { curveControl } from "./curve";
import type { Section } from "./group";
import { keyedControl } from "./keys";
import { listControl, mapControl } from "./list";
import { numberControl } from "./number";
import { usePhotograph } from "../photographs/dialog";
import { vectorControl } from "./vector";

export function controlFor(place: Place, section?: Section): Control {
  switch (place.field.type) {
    case "number":
      return numberControl(place as Place<NumberField>);
    case "boolean":
      return booleanControl(place as Place<PlainField>);
    case "enum":
      return enumControl(place as Place<EnumField>);
    case "text":
      return place.binding.rel.at(-1) === "photo" ? photoControl(place as Place<PlainField>) : textControl(place as Place<PlainField>);
    case "color":
      return colorControl(place as Place<PlainField>);
    case "vector":
      return vectorControl(place as Place<VectorField>);
    case "curve":
      return curveControl(place as Place<PlainField>);
    case "keyed":
      return keyedControl(place as Place<KeyedField>);
    case "list":
      return listControl(place as Place<ListField>, section);
    case "map":
      return mapControl(place as Place<PlainField>);
    default:
      return jsonControl(place as Place<PlainField>);
  }
}

/** The name of a file that may be made of a photograph here. */
function photoControl(place: Place<PlainField>): Control {
  const text = textControl(place);
  const open = el("button.small", { type: "button", "data-testid": "use-photograph", click: () => void usePhotograph(place.binding) }, "Photograph …");
  return { element: el("div.line", {}, text.element, open), refresh: text.refresh };
}
