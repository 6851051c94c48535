import type { AnyKind } from './kind.ts'
import { near } from './near.ts'
import { neverTouches } from './neverTouches.ts'
import { stays } from './stays.ts'
import { turnsAway } from './turnsAway.ts'

/** Every kind of check by its name in `card.json`. */
export const kinds: { readonly [kind: string]: AnyKind } = { near, neverTouches, stays, turnsAway }
