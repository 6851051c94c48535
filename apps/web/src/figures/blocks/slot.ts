import type { Block } from '@botgarten/blocks'
import type { CardProgram } from '@botgarten/content'
import type { Locale } from '#words/language.svelte.ts'

/** Blocks as a drawing; `width`, `height` in px at the scale of the editor's own blocks, 1. */
export interface BlockPicture {
  readonly svg: SVGSVGElement
  /** What stands on the blocks, line by line. */
  readonly words: string
  /** Names that its styles hang on, for the element round it. */
  readonly look: string
  readonly width: number
  readonly height: number
}

/** Draws blocks as the editor has them. `letters`: in the clear ones. */
interface BlocksFigure {
  readonly drawProgram: (program: CardProgram, locale: Locale, letters: boolean) => Promise<BlockPicture>
  /** A block with what is in it, or one by its type as it lies on the shelf. */
  readonly drawBlock: (block: Block | string, locale: Locale, letters: boolean) => Promise<BlockPicture>
}

let loading: (() => Promise<BlocksFigure>) | null = null

/** Only the editor can draw blocks: the page that names the features says where it is. */
export const fillBlocks = (load: () => Promise<BlocksFigure>): void => void (loading = load)

/** @throws Error on a page that has not said who draws blocks: a mistake in the page */
export function blocksFigure(): Promise<BlocksFigure> {
  if (!loading) throw new Error('Nobody draws blocks on this page.')
  return loading()
}
