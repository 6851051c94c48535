import { building, dev } from '$app/env'
import type { Handle } from '@sveltejs/kit/hooks'

/** Letters too: blocks wait for them, since each is as wide as its words. Clear letters come to those who chose them. */
const preload = ({ type, path }: { readonly type: string; readonly path: string }) =>
  type === 'js' || type === 'css' || (type === 'font' && !path.includes('atkinson'))

/**
 * Every page there is was made at build, and is served without asking here. A page that comes here is one of no card and
 * no item: the browser draws the page that says so, and whoever looks at the answer alone is told by its status.
 */
export const handle: Handle = async ({ event, resolve }) => {
  const response = await resolve(event, { preload })
  if (building || dev || !event.route.id || response.status !== 200) return response
  return new Response(response.body, { status: 404, headers: response.headers })
}
