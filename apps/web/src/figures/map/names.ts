import { mapField, ownMapIn } from '@botgarten/blocks'
import type { Project } from '@botgarten/programs'
import { hasMessage, message } from '#words/message.ts'

/** What a map is called: by its maker, or in the language of now; the id of one that is not there. */
export function mapName(map: string, own: Project['maps'] = {}): string {
  const mine = ownMapIn(map)
  if (mine !== null) return own[mine]?.name || mine
  const key = `choice.${mapField(map)}`
  return hasMessage(key) ? message(key) : map
}
