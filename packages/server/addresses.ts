import type { NetworkInterfaceInfo } from 'node:os'

/**
 * Where a server on all addresses can be reached, this machine's own name first.
 * Link-local IPv6 (fe80::) is left out: browsers take no zone in an address.
 */
export function addresses(
  port: number,
  interfaces: { readonly [name: string]: readonly NetworkInterfaceInfo[] | undefined },
): string[] {
  const others = Object.values(interfaces)
    .flatMap((list) => list ?? [])
    .filter(({ internal, address }) => !internal && !address.toLowerCase().startsWith('fe80:'))
    .map(({ family, address }) => (family === 'IPv6' ? `[${address}]` : address))
  return ['localhost', ...others].map((host) => `http://${host}:${port}`)
}
