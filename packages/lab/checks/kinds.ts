import { arrives } from './arrives.ts'
import { clean } from './clean.ts'
import { closed } from './closed.ts'
import { cruises } from './cruises.ts'
import { eyesDecide, netDecides } from './decides.ts'
import { judged } from './judged.ts'
import { keptBack } from './keptBack.ts'
import type { AnyKind } from './kind.ts'
import { laps } from './laps.ts'
import { learned } from './learned.ts'
import { led } from './led.ts'
import { near } from './near.ts'
import { neverCheats } from './neverCheats.ts'
import { neverSees } from './neverSees.ts'
import { neverTouches } from './neverTouches.ts'
import { raced } from './raced.ts'
import { rests } from './rests.ts'
import { rowsBy } from './rowsBy.ts'
import { says } from './says.ts'
import { settled } from './settled.ts'
import { showsGroups } from './showsGroups.ts'
import { silent } from './silent.ts'
import { sings } from './sings.ts'
import { speedOn } from './speedOn.ts'
import { stays } from './stays.ts'
import { tried } from './tried.ts'
import { turnsAway } from './turnsAway.ts'
import { turnsBack } from './turnsBack.ts'
import { visits } from './visits.ts'

/** Every kind of check by its name in `card.json`. */
export const kinds: { readonly [kind: string]: AnyKind } = {
  arrives,
  clean,
  closed,
  cruises,
  eyesDecide,
  judged,
  keptBack,
  laps,
  learned,
  led,
  near,
  netDecides,
  neverCheats,
  neverSees,
  neverTouches,
  raced,
  rests,
  rowsBy,
  says,
  settled,
  showsGroups,
  silent,
  sings,
  speedOn,
  stays,
  tried,
  turnsAway,
  turnsBack,
  visits,
}
