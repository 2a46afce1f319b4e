/** Which control shows which kind of value. */

import type { EnumField, KeyedField, ListField, NumberField, PlainField, VectorField } from "../schema";
import { booleanControl, enumControl, jsonControl, textControl } from "./choice";
import { colorControl } from "./color";
import type { Control, Place } from "./control";
import { curveControl } from "./curve";
import type { Section } from "./group";
import { keyedControl } from "./keys";
import { listControl, mapControl } from "./list";
import { numberControl } from "./number";
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
      return textControl(place as Place<PlainField>);
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
