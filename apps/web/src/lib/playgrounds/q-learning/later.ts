import type { Desk } from '#lib/state/desk.svelte.ts'
import type { Session } from '#lib/state/session.svelte.ts'
import { fetchLateWords } from '#lib/words/say.ts'
import { Learning, type Blocks } from './learning.svelte.ts'

export { default as QPlayground } from './QPlayground.svelte'

/** The playground of a session, with its words. */
export async function openLearning(session: Session, desk: Desk, blocks: Blocks): Promise<Learning> {
  await fetchLateWords()
  return new Learning(session, desk, blocks)
}
