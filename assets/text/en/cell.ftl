### cell
