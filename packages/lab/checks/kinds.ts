import { arrives } from './arrives.ts'
import { eyesDecide } from './eyesDecide.ts'
import type { AnyKind } from './kind.ts'
import { laps } from './laps.ts'
import { led } from './led.ts'
import { near } from './near.ts'
import { neverSees } from './neverSees.ts'
import { neverTouches } from './neverTouches.ts'
import { rests } from './rests.ts'
import { says } from './says.ts'
import { showsGroups } from './showsGroups.ts'
import { sings } from './sings.ts'
import { speedOn } from './speedOn.ts'
import { stays } from './stays.ts'
import { turnsAway } from './turnsAway.ts'
import { turnsBack } from './turnsBack.ts'
import { visits } from './visits.ts'

/** Every kind of check by its name in `card.json`. */
export const kinds: { readonly [kind: string]: AnyKind } = {
  arrives,
  eyesDecide,
  laps,
  led,
  near,
  neverSees,
  neverTouches,
  rests,
  says,
  showsGroups,
  sings,
  speedOn,
  stays,
  turnsAway,
  turnsBack,
  visits,
}
