import { building, dev } from '$app/env'
import type { Handle } from '@sveltejs/kit/hooks'

/** Letters too: blocks wait for them, since each is as wide as its words. Clear letters come to those who chose them. */
const preload = ({ type, path }: { readonly type: string; readonly path: string }) =>
  type === 'js' || type === 'css' || (type === 'font' && !path.includes('atkinson'))

/** Where the build leaves which script holds what; a web space has a folder of its own (vite.config.ts). */
const manifest = `.svelte-kit/${process.env['BOTGARTEN_WEB_SPACE'] ? 'web-space/' : ''}output/client/.vite/manifest.json`

/** The script with a card is asked for by scripts that are long under way: its page names it, and it travels beside them. */
async function linkToCard(card: string, { pathname }: URL): Promise<string> {
  const { readFile } = await import('node:fs/promises')
  const built = JSON.parse(await readFile(manifest, 'utf8')) as { [id: string]: { file: string } | undefined }
  const file = built[`content:card/${card}`]?.file
  // A web space's pages are folders, a level deeper.
  const root = pathname.endsWith('/') ? '../../' : '../'
  return file ? `<link href="${root}${file}" rel="modulepreload">` : ''
}

/**
 * Every page there is was made at build, and is served without asking here. A page that comes here is one of no card and
 * no item: the browser draws the page that says so, and whoever looks at the answer alone is told by its status.
 */
export const handle: Handle = async ({ event, resolve }) => {
  const { card } = event.params
  const link = building && card ? await linkToCard(card, event.url) : ''
  const transformPageChunk = ({ html }: { html: string }) => html.replace('</head>', `${link}</head>`)
  const response = await resolve(event, { preload, transformPageChunk })
  if (building || dev || !event.route.id || response.status !== 200) return response
  return new Response(response.body, { status: 404, headers: response.headers })
}
