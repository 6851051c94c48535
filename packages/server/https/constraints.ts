/** DER of something short (X.690, 8.1). */
const der = (tag: number, ...parts: readonly Iterable<number>[]): number[] => {
  const content = parts.flatMap((part) => [...part])
  if (content.length > 127) throw new RangeError('longer than a short length of DER')
  return [tag, content.length, ...content]
}

const sequence = 0x30
const permitted = 0xa0
const subtree = (name: number[]) => der(sequence, name)
const dnsName = (name: string) => subtree(der(0x82, Buffer.from(name, 'ascii')))
const addresses = (network: readonly number[], mask: readonly number[]) => subtree(der(0x87, network, mask))

/** For what an authority of a classroom may vouch: its own name, and addresses of private networks (RFC 1918). */
const subtrees = [
  dnsName('botgarten.local'),
  addresses([10, 0, 0, 0], [255, 0, 0, 0]),
  addresses([172, 16, 0, 0], [255, 240, 0, 0]),
  addresses([192, 168, 0, 0], [255, 255, 0, 0]),
]

/** Value of the extension "name constraints" (RFC 5280, 4.2.1.10). */
export const nameConstraints = Uint8Array.from(der(sequence, der(permitted, ...subtrees)))

/** Is an IPv4 address one of those that the authority may vouch for? */
export function isPrivate(address: string): boolean {
  const [a, b] = address.split('.').map(Number)
  return a === 10 || (a === 172 && b! >= 16 && b! < 32) || (a === 192 && b === 168)
}
