/// <reference types="@sveltejs/kit" />
// Keeps the whole lab on the device, so that it starts with the network cable pulled. A new version is fetched beside the
// old one and waits: it takes over when every page is closed, or when the home page asks for it and no lab is open.
import { version } from '$app/env'
import { assets, immutable, prerendered } from '$app/manifest'
import { self } from '$app/service-worker'
import { ofTeachers } from 'virtual:files-of-teachers'
import { isPast, oneOf, storeOf, wayOf } from './way.ts'

const scope = new URL('./', self.location.href)
const addressOf = ({ path }: { readonly path: string }) => new URL(path.replace(/^\//, ''), scope).href
const own = {
  scope: scope.href,
  // A teacher's pages, and the files that only they load, are of no use without the server.
  pages: new Set(prerendered.filter(({ path }) => !/^\/?teacher(\/|$)/.test(path)).map(addressOf)),
  // Who installs the lab is given its icons then; nobody asks a page for a notice.
  files: new Set(
    [
      ...immutable.filter(({ path }) => !ofTeachers.some((file) => path.endsWith(file))),
      ...assets.filter(({ path }) => !/icon-.*png$|NOTICE/.test(path)),
    ].map(addressOf),
  ),
}
const store = storeOf(version)

/** Everything, or nothing: an install that misses a part is tried again with the next visit. */
async function keepAll(): Promise<void> {
  const kept = await caches.open(store)
  const pages = new Set([...own.pages].map((page) => oneOf(page, own)))
  const asked = [...own.files, ...pages].map(
    // What has no hash in its name is asked for again.
    (address) => new Request(address, address.includes('/immutable/') ? {} : { cache: 'reload' }),
  )
  await kept.addAll(asked)
}

async function forgetPast(): Promise<void> {
  const all = await caches.keys()
  await Promise.all(all.filter((name) => isPast(name, all, version)).map((name) => caches.delete(name)))
}

/** What is kept at an address; pages that are still open find the parts of the version before. */
async function kept(address: string): Promise<Response | undefined> {
  const how = { ignoreVary: true, ignoreSearch: true }
  return (await (await caches.open(store)).match(address, how)) ?? (await caches.match(address, how))
}

/** A page that a server has led elsewhere must not answer for an address of its own. */
const plain = (answer: Response): Response =>
  answer.redirected ? new Response(answer.body, { status: answer.status, headers: answer.headers }) : answer

async function newest(request: Request): Promise<Response> {
  try {
    const answer = await fetch(request)
    if (answer.ok) await (await caches.open(store)).put(request, answer.clone())
    return answer
  } catch (cause) {
    const before = await kept(request.url)
    if (before) return before
    throw cause
  }
}

async function home(request: Request): Promise<Response> {
  try {
    return await fetch(request)
  } catch {
    return Response.redirect(scope.href)
  }
}

self.addEventListener('install', (event) => event.waitUntil(keepAll()))

self.addEventListener('activate', (event) => event.waitUntil(forgetPast().then(() => self.clients.claim())))

self.addEventListener('message', ({ data }) => {
  if (data === 'take over') void self.skipWaiting()
})

self.addEventListener('fetch', (event) => {
  const { request } = event
  const way = wayOf(request, own)
  if (way.kind === 'kept')
    event.respondWith(kept(way.address).then((answer) => (answer ? plain(answer) : fetch(request))))
  else if (way.kind === 'moved') event.respondWith(Response.redirect(way.address))
  else if (way.kind === 'newest') event.respondWith(newest(request))
  else if (way.kind === 'home') event.respondWith(home(request))
})
