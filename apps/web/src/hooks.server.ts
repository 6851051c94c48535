import { building, dev } from '$app/env'
import type { Handle } from '@sveltejs/kit/hooks'
import { allCards } from '#content/cards.ts'

/** Letters too: blocks wait for them, since each is as wide as its words. Clear letters come to those who chose them. */
const preload = ({ type, path }: { readonly type: string; readonly path: string }) =>
  type === 'js' || type === 'css' || (type === 'font' && !path.includes('atkinson'))

/** Where the build leaves which script holds what; a web space has a folder of its own (vite.config.ts). */
const manifest = `.svelte-kit/${process.env['BOTGARTEN_WEB_SPACE'] ? 'web-space/' : ''}output/client/.vite/manifest.json`

/** The picture a card is played on, below `content/`; undefined where it is played on a colour. */
const floorOf = (card: string) => allCards.find(({ id }) => id === card)?.floor?.replace('content:', '')

/**
 * What says what a card is, the picture of its floor and that picture's pixels are asked for by scripts that are long under
 * way: its page names them, and they travel beside these.
 */
async function linksToCard(card: string, { pathname }: URL): Promise<string> {
  const { readFile } = await import('node:fs/promises')
  const built = JSON.parse(await readFile(manifest, 'utf8')) as { [id: string]: { file: string } | undefined }
  const floor = floorOf(card)
  const world = floor?.split('/').at(-2)
  const script = built[`content:card/${card}`]?.file
  const picture = floor && built[`../../content/${floor}`]?.file
  const pixels = Object.entries(built).find(
    ([id]) => id.startsWith(`_${world}.`) && id.endsWith('.pixels'),
  )?.[1]?.file
  // A web space's pages are folders, a level deeper.
  const root = pathname.endsWith('/') ? '../../' : '../'
  return [
    script && `<link href="${root}${script}" rel="modulepreload">`,
    pixels && `<link href="${root}${pixels}" rel="preload" as="fetch" crossorigin>`,
    picture && `<link href="${root}${picture}" rel="preload" as="image">`,
  ]
    .filter((link) => link)
    .join('')
}

const fonts = /<link [^>]*as="font"[^>]*>/g

/** Letters are needed last, by the blocks: scripts go before them. */
const withFontsLast = (html: string, links: string) =>
  html.replace(fonts, '').replace('</head>', `${(html.match(fonts) ?? []).join('')}${links}</head>`)

/**
 * Every page there is was made at build, and is served without asking here. A page that comes here is one of no card and
 * no item: the browser draws the page that says so, and whoever looks at the answer alone is told by its status.
 */
export const handle: Handle = async ({ event, resolve }) => {
  const { card } = event.params
  const links = building && card ? await linksToCard(card, event.url) : ''
  const transformPageChunk = ({ html }: { html: string }) => withFontsLast(html, links)
  const response = await resolve(event, { preload, transformPageChunk })
  if (building || dev || !event.route.id || response.status !== 200) return response
  return new Response(response.body, { status: 404, headers: response.headers })
}
