/**
 * How a mat made on this device is told from every other world: by its name. No world of the site
 * and no file saved here has an underscore in its name. Imports nothing of ours.
 */

export function isOwnMat(name: string): boolean {
  return /^own_[a-z0-9]{6}$/.test(name);
}
