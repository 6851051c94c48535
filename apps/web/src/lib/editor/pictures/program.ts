import type { CardProgram } from '@botgarten/materials'
import type { Program } from '@botgarten/programs'
import type { Locale } from '#lib/words/language.svelte.ts'
import { fetchBlocklyWords } from '../blockly-words.ts'
import { fontReady } from '../looks.ts'
import { bringFor } from '../packs.ts'
import { toWorkspace } from '../program.ts'
import { drawn, type BlockPicture } from './blocks.ts'
import { tellFolded } from './folded.ts'

/** A card's program, drawn by the editor's own renderer. */
export async function drawProgram(
  program: CardProgram,
  locale: Locale,
  letters: boolean,
): Promise<BlockPicture> {
  await Promise.all([bringFor(program), fetchBlocklyWords(locale), fontReady(letters)])
  const first: Program = Object.values(program.programs)[0]!
  return drawn(locale, letters, (paper) => {
    toWorkspace(first, paper)
    tellFolded(paper)
  })
}
