import { spawn } from 'node:child_process'

/** What opens a page in the browser that its system has chosen, and the words before the address. */
const openers: { readonly [platform: string]: readonly string[] } = {
  // `start` would have the shell read the address.
  win32: ['rundll32', 'url.dll,FileProtocolHandler'],
  darwin: ['open'],
  linux: ['xdg-open'],
}

/** Shows a page on this machine. Where nothing can, nothing happens: the address stands in the window. */
export function openPage(address: string, platform: string = process.platform): void {
  const [program, ...before] = openers[platform] ?? []
  if (program === undefined) return
  const opener = spawn(program, [...before, address], { stdio: 'ignore', detached: true })
  opener.once('error', () => {})
  opener.unref()
}
