import type { WordsFile } from '#words/generated/files.ts'
import { withWords } from '#words/message.ts'

/**
 * What a feature says of itself in its door, `features/<id>/feature.ts`; other rooms know nothing else of it. What a page
 * shows at once the door exports, all the rest is one part that comes when it is first asked for.
 */
export interface Feature {
  /** Name of its folder. */
  readonly id: string
  /** Files of messages that it says besides those of every page. */
  readonly words: readonly WordsFile[]
  /** The page that shows it at once, without its first slash. */
  readonly route?: string
  readonly load?: () => Promise<unknown>
  /** Most bytes of scripts (brotli) that its lazy part may add to the page that asks for it, where that is over 100 kB. */
  readonly budget?: number
}

/** A feature with a part that comes when it is asked for. */
interface Lazy<Part> extends Feature {
  readonly load: () => Promise<Part>
}

/**
 * The lazy part of a feature, once its messages have come too.
 * @param failed withdraws the request where it cannot be loaded, so that the next press asks again
 */
export const loadPart = <Part>({ load, words }: Lazy<Part>, failed?: () => void): Promise<Part> =>
  withWords(load(), words, failed)
