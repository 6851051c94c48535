import { arrives } from './arrives.ts'
import type { AnyKind } from './kind.ts'
import { led } from './led.ts'
import { near } from './near.ts'
import { neverTouches } from './neverTouches.ts'
import { showsGroups } from './showsGroups.ts'
import { stays } from './stays.ts'
import { turnsAway } from './turnsAway.ts'
import { visits } from './visits.ts'

/** Every kind of check by its name in `card.json`. */
export const kinds: { readonly [kind: string]: AnyKind } = {
  arrives,
  led,
  near,
  neverTouches,
  showsGroups,
  stays,
  turnsAway,
  visits,
}
