import type { Facts } from '@botgarten/blocks'
import { say } from '#words/say.ts'

/** A refusal in a child's words. */
export const wordsOfRefusal = (problem: string, facts: Facts = {}) => ({
  title: say(`problem.${problem}.title`, facts),
  text: say(`problem.${problem}.text`, facts),
})
