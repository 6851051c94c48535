import { m } from '#words/message.ts'
import { thingName } from '#content/thing-name.ts'
import type { Item } from './edits.ts'

/** What a child calls it. */
export function nameOf(item: Item): string {
  if (item.kind === 'obstacles') return thingName(item.thing)
  return item.kind === 'areas' ? m['build.area']() : m['build.line']()
}
