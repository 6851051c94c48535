import * as Blockly from 'blockly/core'
import { asset } from '$app/paths'
import { stacksOf, toolbox, type Block, type Template } from '@botgarten/blocks'
import type { Program } from '@botgarten/programs'
import '../editor.css'
import { inject } from '../audio.ts'
import { fetchBlocklyWords } from '../blockly-words.ts'
import { fontReady, options } from '../looks.ts'
import { loadFor, loadLearning } from '../../model/packs.ts'
import { append, toWorkspace } from '../../model/program.ts'
import { tellFolded } from './folded.ts'
import { setUp, speak } from '../setup.ts'
import { stateOfTemplate } from '../../model/state.ts'
import type { CardProgram } from '@botgarten/content'
import type { BlockPicture } from '#figures/blocks/slot.ts'
import type { Locale } from '#words/language.svelte.ts'

/** A card's program, drawn by the editor's own renderer; `dress` changes what stands on the workspace. */
export async function drawProgram(
  program: CardProgram,
  locale: Locale,
  letters: boolean,
): Promise<BlockPicture> {
  await Promise.all([loadFor(program), fetchBlocklyWords(locale), fontReady(letters)])
  const first: Program = Object.values(program.programs)[0]!
  return drawn(locale, letters, (workspace) => {
    toWorkspace(first, workspace)
    tellFolded(workspace)
  })
}

const inToolbox = (type: string) =>
  toolbox.flatMap(({ blocks }) => blocks).find((one) => one.type === type) ?? { type }

/** A block with what is in its sockets; of a type alone: as it lies on the toolbox, with its presets. */
export async function drawBlock(
  block: Block | string,
  locale: Locale,
  letters: boolean,
): Promise<BlockPicture> {
  await Promise.all([loadLearning(), fetchBlocklyWords(locale), fontReady(letters)])
  const template = typeof block === 'string' ? inToolbox(block) : block
  return drawn(locale, letters, (workspace) => {
    Blockly.serialization.blocks.append(stateOfTemplate(template), workspace)
  })
}

/** Between an example's stacks. */
const apart = 24

/** The example of a type whose language is there: its blocks stand out. */
export async function drawExample(
  example: readonly Template[],
  type: string,
  locale: Locale,
  letters: boolean,
): Promise<BlockPicture> {
  await Promise.all([fetchBlocklyWords(locale), fontReady(letters)])
  return drawn(locale, letters, (workspace) => {
    for (const row of stacksOf(example)) {
      const y = workspace.getBlocksBoundingBox().bottom + apart
      append({ x: 0, y, blocks: row as readonly Block[] }, workspace)
    }
    for (const block of workspace.getAllBlocks(false).filter((block) => block.type === type))
      block.getSvgRoot().classList.add('editor-highlight')
  })
}

/** The drawing stays when the workspace it was made on is thrown away: only the styles of the editor are needed. */
function drawn(
  locale: Locale,
  letters: boolean,
  fill: (workspace: Blockly.WorkspaceSvg) => void,
): BlockPicture {
  setUp()
  speak(locale)
  const host = document.createElement('div')
  host.style.cssText = 'position:absolute;left:-4000px;width:1200px;height:900px;visibility:hidden'
  document.body.append(host)
  const media = asset('blockly/sprites.svg').replace('sprites.svg', '')
  const workspace = inject(host, {
    ...options(locale, media, { letters, large: false }),
    ...{ toolbox: undefined, readOnly: true, plugins: {}, grid: undefined, zoom: { startScale: 1 } },
    move: { scrollbars: false, drag: false, wheel: false },
  })
  try {
    fill(workspace)
    return pictureOf(workspace)
  } finally {
    // Blockly measures words on a canvas at the end of the body; it shows nothing.
    document.querySelector('.blocklyComputeCanvas')?.setAttribute('aria-hidden', 'true')
    workspace.dispose()
    host.remove()
  }
}

function pictureOf(workspace: Blockly.WorkspaceSvg): BlockPicture {
  const { left, top, right, bottom } = workspace.getBlocksBoundingBox()
  const edge = 3
  const [width, height] = [right - left + 2 * edge, bottom - top + 2 * edge]
  const svg = workspace.getParentSvg().cloneNode(false) as SVGSVGElement
  const blocks = workspace.getCanvas().cloneNode(true) as SVGGElement
  blocks.removeAttribute('transform')
  for (const part of [svg, ...blocks.querySelectorAll('*')])
    for (const name of ['id', 'tabindex', 'role', ...ariaOf(part)]) part.removeAttribute(name)
  svg.append(blocks)
  svg.setAttribute('viewBox', `${left - edge} ${top - edge} ${width} ${height}`)
  svg.setAttribute('aria-hidden', 'true')
  for (const name of ['width', 'height', 'style']) svg.removeAttribute(name)
  return {
    svg,
    words: wordsOn(workspace.getCanvas()),
    look: workspace.getInjectionDiv().className,
    width,
    height,
  }
}

/** Blockly draws words in another order than they are read in. Half a line apart is another line. */
function wordsOn(canvas: Element): string {
  const words = [...canvas.querySelectorAll('text')].map((text) => {
    const { left, top, height } = text.getBoundingClientRect()
    return { said: text.textContent.trim(), left, middle: top + height / 2 }
  })
  words.sort((a, b) => (Math.abs(a.middle - b.middle) < 10 ? a.left - b.left : a.middle - b.middle))
  return words
    .map(({ said }) => said)
    .filter(Boolean)
    .join(' ')
}

const ariaOf = (element: Element) => element.getAttributeNames().filter((name) => name.startsWith('aria-'))
